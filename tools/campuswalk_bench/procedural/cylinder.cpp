#include "tools/campuswalk_bench/procedural/cylinder.h"

#include <cstdint>
#include <numbers>

#include <Eigen/Core>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::tools::bench {

collision::TriangleMesh cylinder(const CylinderShape& shape) {
    collision::TriangleMesh mesh;
    const double bottom = -shape.height / 2.0;
    for (int stack = 0; stack <= shape.stacks; ++stack) {
        for (int side = 0; side < shape.sides; ++side) {
            const auto [sin, cos] = collision::sin_cos(2.0 * std::numbers::pi * side / shape.sides);
            const double z = bottom + shape.height * stack / shape.stacks;
            const Eigen::Vector3d vertex(shape.radius * cos, shape.radius * sin, z);
            mesh.positions.emplace_back(vertex.cast<float>());
        }
    }
    const auto bottom_center = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0.0F, 0.0F, static_cast<float>(bottom));
    mesh.positions.emplace_back(0.0F, 0.0F, static_cast<float>(-bottom));

    const auto at = [&](int stack, int side) {
        return static_cast<std::uint32_t>(stack * shape.sides + side % shape.sides);
    };
    for (int stack = 0; stack < shape.stacks; ++stack) {
        for (int side = 0; side < shape.sides; ++side) {
            const std::uint32_t opposite = at(stack + 1, side + 1);
            mesh.triangles.push_back({at(stack, side), at(stack, side + 1), opposite});
            mesh.triangles.push_back({at(stack, side), opposite, at(stack + 1, side)});
        }
    }
    for (int side = 0; side < shape.sides; ++side) {
        mesh.triangles.push_back({bottom_center, at(0, side + 1), at(0, side)});
        mesh.triangles.push_back({bottom_center + 1, at(shape.stacks, side), at(shape.stacks, side + 1)});
    }
    return mesh;
}

}  // namespace campuswalk::tools::bench
