#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// The lowest node that is each of the nodes or above it; nullopt if they have different roots. `nodes` holds
/// at least one. Visits only what is between them and that node, each node once.
std::optional<std::size_t> common_ancestor(const Model& model, const std::vector<std::size_t>& nodes);

}  // namespace campuswalk::scene
