#pragma once

#include <filesystem>
#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"
#include "config/loader/walk/read_camera.h"
#include "config/loader/walk/walk_names.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads `steps` into the walk, and which files they include: a list of maps with one key each, the first of
/// them `spawn`. `camera` has the defaults of snapshots; crouched height and running speed are those of the
/// walk's avatar, which has been read.
///
/// `repeat` and `include` are expanded: the result is the flat list that is played, each step with the mark
/// of where it is written, in whatever file. Reports files that include themselves (include-cycle) or are
/// nested deeper than 16 (include-depth), and more than 100,000 steps, or
/// 1,000 included files or 20 MB of them (too-many-steps).
void read_steps(const CheckedNode& section, const WalkNames& names, const CameraKeys& camera,
                const std::filesystem::path& walk_file, const ReadRoots& roots, engine::Walk& walk);

/// Reads a `NAME.steps.yaml` by itself, without a walk: the avatar has AvatarProfile's defaults, and names of
/// places are not checked.
std::vector<engine::Step> read_standalone_steps(const CheckedNode& root, const WalkNames& names,
                                                const std::filesystem::path& steps_file,
                                                const ReadRoots& roots);

}  // namespace campuswalk::config
