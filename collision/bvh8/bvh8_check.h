#pragma once

#include <cstddef>

#include "collision/bvh8/bvh8.h"

namespace campuswalk::collision {

/// For trees that come from a file. Queries believe what a tree says of itself: were it to name what isn't
/// there, or itself, they would read beyond or never end. Whether its boxes are where its triangles are is
/// not looked at: a tree with boxes elsewhere answers wrongly, and no worse.
///
/// What is wrong with the tree of a mesh of so many triangles, in words; null if nothing is.
const char* fault_of(const Bvh8& tree, std::size_t mesh_triangles);

}  // namespace campuswalk::collision
