#pragma once

#include <cstddef>

#include "collision/bvh8/bvh8.h"

namespace campuswalk::collision {

/// Describes what is wrong with a tree, such as one read from a file, for a mesh with so many triangles; null
/// if nothing is. Queries trust a tree: with an index out of range, or a cycle, they would read out of bounds
/// or never end. Doesn't check that the boxes contain their triangles: queries of such a tree only return
/// wrong results.
const char* fault_of(const Bvh8& tree, std::size_t mesh_triangles);

}  // namespace campuswalk::collision
