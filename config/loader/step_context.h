#pragma once

#include <filesystem>
#include <vector>

#include "config/loader/campus_names.h"
#include "config/loader/names.h"
#include "config/loader/read_camera.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// What the readers of steps share.
struct StepContext {
    const CampusNames& names;
    const engine::AvatarProfile& avatar;
    const CameraKeys& camera;
    std::vector<std::filesystem::path> files;  ///< being read: the walk, what it includes, and so on
    UniqueNames snapshots{"snapshot"};
    bool first = true;     ///< nothing has been read yet
    int repeats = 0;       ///< around what is read
    std::size_t read = 0;  ///< steps so far, every round of a `repeat` counted
};

}  // namespace campuswalk::config
