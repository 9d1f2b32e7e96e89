#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/campus/campus_description.h"

namespace campuswalk::scene {

/// The building that a collider belongs to, as an index into CampusDescription::buildings.
std::optional<std::size_t> building_of(const CampusDescription& campus, const ColliderDescription& collider);

/// The globs that select a collider's nodes: its own, or its building's if it needs nodes and has no globs.
const std::vector<NodeGlob>& globs_of(const CampusDescription& campus, const ColliderDescription& collider);

}  // namespace campuswalk::scene
