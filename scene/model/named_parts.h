#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::scene {

constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);

/// By node: the index of the part that contains it, or kNoPart. A part, such as one door, is the subtree of
/// the topmost node whose name matches; groups are skipped: nodes without meshes that have matching
/// descendants, such as "doors" above "door 1" and "door 2".
std::vector<std::size_t> named_parts(const Model& model, bool (*name_matches)(std::string_view));

}  // namespace campuswalk::scene
