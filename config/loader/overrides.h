#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "config/loader/yaml/yaml_tree.h"

namespace campuswalk::config {

/// A value from another file that replaces a walk's own; none if `node` is null.
struct Override {
    std::shared_ptr<const YamlNode> node;
    std::string file;              ///< as diagnostics show it
    std::filesystem::path folder;  ///< what the file's paths are relative to

    explicit operator bool() const { return node != nullptr; }
};

/// What a project of walks.config.yaml changes in its walks.
struct Overrides {
    Override campus;  ///< a file's name
    Override avatar;  ///< as a walk's `avatar`
    Override spawn;   ///< as the value of a `spawn` step; replaces the first step's
};

}  // namespace campuswalk::config
