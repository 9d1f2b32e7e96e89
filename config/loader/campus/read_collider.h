#pragma once

#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/names.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Globs over node names: one, or a list.
std::vector<scene::NodeGlob> node_globs(const CheckedNode& node);

/// Reads an entry of `colliders` and adds its id to `ids`. Its layer and its building must be among those
/// that have already been read into `campus`.
scene::ColliderDescription read_collider(const CheckedNode& node, const scene::CampusDescription& campus,
                                         UniqueNames& ids);

}  // namespace campuswalk::config
