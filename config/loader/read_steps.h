#pragma once

#include <vector>

#include "config/loader/campus_names.h"
#include "config/loader/checked_node.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads `steps`: a list of maps with one key each, the first of them `spawn`. Snapshots take their camera
/// from `camera` where they don't say otherwise.
std::vector<engine::Step> read_steps(const CheckedNode& section, const CampusNames& names,
                                     const engine::CameraSettings& camera);

}  // namespace campuswalk::config
