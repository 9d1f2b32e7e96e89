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
    std::optional<std::size_t> pairs;  ///< overlapping ones, where they are known beforehand
};

/// Two meshes and where they are.
struct PairScene {
    std::string name;  ///< the CSV's `case`
    collision::TriangleMesh a;
    collision::TriangleMesh b;
    std::vector<PairPlacement> placements;
};

/// The paper's: a cylinder and a teapot, ten placements.
PairScene table1_scene();

/// Both of them with `fineness` times the quads along each edge, in the placement that has 666 pairs in
/// Table I. 11 makes a million triangles each.
PairScene finer_scene(int fineness);

inline constexpr double kNestedGap = 0.02;  ///< metres

/// Table I's cylinder and one that fits into it with kNestedGap between all their faces, axis on axis. The
/// inner one is turned by half a side and a little, so that neither edges nor faces lie side by side.
PairScene nested_scene();

}  // namespace campuswalk::tools::bench
