#pragma once

#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/names.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Globs over node names: one, or a list of them.
std::vector<scene::NodeGlob> node_globs(const CheckedNode& node);

/// Reads one of `colliders`. Its layer and its building must be among those of `campus`, which has been read
/// so far; its id goes to `ids`.
scene::ColliderDescription read_collider(const CheckedNode& node, const scene::CampusDescription& campus,
                                         UniqueNames& ids);

}  // namespace campuswalk::config
