#pragma once

#include <filesystem>
#include <optional>

#include "scene/campus_description.h"

namespace campuswalk::tools {

struct InfoOptions {
    scene::SceneFile scene;
    bool json = false;
    std::optional<std::filesystem::path> suggest;  ///< NAME.campus.yaml to write, with NAME.walk.yaml
    bool overwrite = false;                        ///< those two
};

/// Prints what is in a model file and what looks odd about it. Returns the exit code.
int print_info(const InfoOptions& options);

}  // namespace campuswalk::tools
