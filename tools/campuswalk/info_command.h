#pragma once

#include <filesystem>
#include <optional>

#include "scene/campus/campus_description.h"
#include "tools/campuswalk/rendering_backend.h"

namespace campuswalk::tools {

struct InfoOptions {
    scene::SceneFile scene;
    bool json = false;
    std::optional<std::filesystem::path> suggest;  ///< NAME.campus.yaml to write, with NAME.walk.yaml
    bool overwrite = false;                        ///< those two
    std::optional<std::filesystem::path> map;      ///< an image from above to write
    Backend backend = Backend::automatic;          ///< that draws it
};

/// Prints what is in a model file and what looks odd about it. Returns the exit code.
int print_info(const InfoOptions& options);

}  // namespace campuswalk::tools
