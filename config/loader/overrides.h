#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "config/loader/yaml/yaml_tree.h"

namespace campuswalk::config {

/// A value that another file gives in the place of a walk's own; none when `node` is null.
struct Override {
    std::shared_ptr<const YamlNode> node;
    std::string file;              ///< as diagnostics show it
    std::filesystem::path folder;  ///< what the file's paths are relative to

    explicit operator bool() const { return node != nullptr; }
};

/// What a project of walks.config.yaml changes about the walks it plays.
struct Overrides {
    Override campus;  ///< a file's name
    Override avatar;  ///< like a walk's `avatar`
    Override spawn;   ///< like a `spawn` step's value; goes into the first step
};

}  // namespace campuswalk::config
