#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

struct PairPlacement {
    collision::Pose X_a_b;
    std::optional<std::size_t> pairs;  ///< overlapping pairs, if known beforehand
};

/// Two meshes and their relative placements.
struct PairScene {
    std::string name;  ///< the CSV's `case`
    collision::TriangleMesh a;
    collision::TriangleMesh b;
    std::vector<PairPlacement> placements;
};

/// The paper's scene: a cylinder and a teapot in ten placements.
PairScene table1_pair_scene();

/// The same meshes with `fineness` times the quads along each edge, in the placement that has 666 pairs in
/// Table I. 11 makes a million triangles each.
PairScene finer_scene(int fineness);

inline constexpr double kNestedGap = 0.02;  ///< metres

/// Table I's cylinder and a coaxial one inside it with kNestedGap between all their faces. The inner one is
/// rotated by slightly more than half a side, so that neither edges nor faces are parallel neighbours.
PairScene nested_scene();

}  // namespace campuswalk::tools::bench
