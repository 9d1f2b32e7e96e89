#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/names.h"
#include "config/loader/values/read_roots.h"
#include "config/loader/walk/read_camera.h"
#include "config/loader/walk/walk_names.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// What the readers of steps share.
struct StepContext {
    const WalkNames& names;
    const engine::AvatarProfile& avatar;
    const CameraKeys& camera;
    const ReadRoots& roots;
    std::vector<std::filesystem::path> files;  ///< being read: the walk's, the one it includes, and so on
    bool standalone = false;                   ///< steps that any walk may include, with any camera
    UniqueNames snapshots{"snapshot"};
    bool first = true;                                 ///< no step has been read yet
    int repeats = 0;                                   ///< nesting depth of `repeat`
    std::size_t read = 0;                              ///< steps so far, counting every round of a `repeat`
    std::vector<std::filesystem::path> included = {};  ///< files so far, each time that one is included
    std::uintmax_t included_bytes = 0;                 ///< of these
};

/// Reads the value of a step's key and reports its errors.
struct StepReader {
    std::string_view name;
    engine::Step (*read)(const CheckedNode&, StepContext&) = nullptr;
};

/// For every step but `repeat` and `include`, which expand to others; `spawn` comes first.
std::span<const StepReader> step_readers();

}  // namespace campuswalk::config
