#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::scene {

constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);

/// By node: the part that it is or is below of, else kNoPart. A part is a node of which `is_called(name)`,
/// but not one that only gathers such nodes ("doors", with "door 1" and "door 2" below it and no mesh of its
/// own); of one below another, the topmost.
std::vector<std::size_t> named_parts(const Model& model, bool (*is_called)(std::string_view));

}  // namespace campuswalk::scene
