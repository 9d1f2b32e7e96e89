#pragma once

#include <compare>
#include <cstdint>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

struct TrianglePair {
    std::uint32_t a = 0;  ///< triangle of the first mesh
    std::uint32_t b = 0;  ///< triangle of the second

    auto operator<=>(const TrianglePair&) const = default;
};

/// A vertex of b in a's frame: the only rounding between the input and the result of mesh against mesh. Each
/// row's products are added from left to right, the translation last.
inline Vec3 b_vertex_in_a(const Pose& X_a_b, const Eigen::Vector3f& vertex) {
    const Mat3& R = X_a_b.rotation;
    const double x = vertex.x();
    const double y = vertex.y();
    const double z = vertex.z();
    const auto row = [&](int i) {
        return ((R(i, 0) * x + R(i, 1) * y) + R(i, 2) * z) + X_a_b.translation[i];
    };
    return {row(0), row(1), row(2)};
}

}  // namespace campuswalk::collision
