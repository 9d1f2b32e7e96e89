#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/geometry/campus_geometry.h"

namespace campuswalk::engine::render {

/// Which triangles (three indices each) have a twin: one with the same three corners, equal to the bit, in
/// the opposite winding. SketchUp and others export both sides of a sheet so. One value a triangle.
/// `families` has a number for each triangle: only those of one family can be twins.
std::vector<bool> reversed_twins(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                                 std::span<const std::uint32_t> families);

}  // namespace campuswalk::engine::render
