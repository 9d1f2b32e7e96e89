#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/geometry/campus_geometry.h"

namespace campuswalk::engine::render {

/// For each triangle (three indices), whether another has bitwise the same vertex positions in the opposite
/// winding: SketchUp and others export both sides of a sheet this way. Only triangles with the same entry in
/// `groups` (one per triangle) are compared.
std::vector<bool> find_reversed_duplicates(std::span<const Vertex> vertices,
                                           std::span<const std::uint32_t> indices,
                                           std::span<const std::uint32_t> groups);

}  // namespace campuswalk::engine::render
