#pragma once

#include <filesystem>
#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/walk/campus_names.h"
#include "config/loader/walk/read_camera.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads `steps`: a list of maps with one key each, the first of them `spawn`. Snapshots take their camera
/// from the walk's where they don't say otherwise; crouching and running are those of its avatar.
///
/// `repeat` and `include` are unrolled: the result is the plain list that is played, each step with the mark
/// of where it is written, in whatever file. Complains of files that include themselves (include-cycle) or
/// others deeper than 16 (include-depth), and of more than 100,000 steps (too-many-steps).
std::vector<engine::Step> read_steps(const CheckedNode& section, const CampusNames& names,
                                     const engine::AvatarProfile& avatar, const CameraKeys& camera,
                                     const std::filesystem::path& walk_file);

/// Reads a `NAME.steps.yaml` that no walk is known of: an avatar like AvatarProfile's defaults, and names of
/// places are taken as they are.
std::vector<engine::Step> read_steps_alone(const CheckedNode& root, const std::filesystem::path& steps_file);

}  // namespace campuswalk::config
