#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "collision/base/storage.h"

namespace campuswalk::collision {

/// Indexed triangles in the mesh's own frame, metres, counter-clockwise seen from outside. Vertices are
/// float32: place the frame's origin near the geometry (the object's pose carries the double offset).
struct TriangleMesh {
    Storage<Eigen::Vector3f> positions;
    Storage<std::array<std::uint32_t, 3>> triangles;
};

/// A triangle's vertices in double precision.
struct Triangle {
    Eigen::Vector3d a = Eigen::Vector3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    Eigen::Vector3d c = Eigen::Vector3d::Zero();
};

inline Triangle vertices(const TriangleMesh& mesh, std::size_t i) {
    const auto& t = mesh.triangles[i];
    return {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
            mesh.positions[t[2]].cast<double>()};
}

}  // namespace campuswalk::collision
