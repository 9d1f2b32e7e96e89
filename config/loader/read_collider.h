#pragma once

#include "config/loader/checked_node.h"
#include "config/loader/names.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads one of `colliders`. Its layer and its building must be among those of `campus`, which has been read
/// so far; its id goes to `ids`.
scene::ColliderDescription read_collider(const CheckedNode& node, const scene::CampusDescription& campus,
                                         UniqueNames& ids);

}  // namespace campuswalk::config
