#include "tests/support/mesh_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace campuswalk::support {

void add_triangle(TriangleMesh& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vector3d& p : {a, b, c}) {
        mesh.positions.push_back(p.cast<float>());
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
}

void add_quad(TriangleMesh& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c,
              const Vector3d& d) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

void add_box(TriangleMesh& mesh, const Vector3d& min, const Vector3d& max) {
    const auto at = [&](int x, int y, int z) {
        return Vector3d(x != 0 ? max.x() : min.x(), y != 0 ? max.y() : min.y(), z != 0 ? max.z() : min.z());
    };
    add_quad(mesh, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
    add_quad(mesh, at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));
    add_quad(mesh, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
    add_quad(mesh, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
    add_quad(mesh, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
    add_quad(mesh, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
}

void add_floor(TriangleMesh& mesh, double half_size, double y, double cell) {
    const int cells = std::max(1, static_cast<int>(std::ceil(2.0 * half_size / cell)));
    const auto line = [&](int i) { return -half_size + 2.0 * half_size * i / cells; };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            add_quad(mesh, {line(i), y, line(j + 1)}, {line(i + 1), y, line(j + 1)},
                     {line(i + 1), y, line(j)}, {line(i), y, line(j)});
        }
    }
}

void add_stairs(TriangleMesh& mesh, double x, double z, double width, double riser, double tread, int steps) {
    const double front = z + width;
    for (int i = 0; i < steps; ++i) {
        const double left = x + i * tread;
        const double right = i + 1 < steps ? left + tread : left + 1.0;
        const double low = i * riser;
        const double high = low + riser;
        add_quad(mesh, {left, low, z}, {left, low, front}, {left, high, front}, {left, high, z});
        add_quad(mesh, {left, high, front}, {right, high, front}, {right, high, z}, {left, high, z});
    }
}

void add_room(TriangleMesh& mesh, const Vector3d& min, const Vector3d& max, double door) {
    constexpr double kThick = 0.2;
    const double middle = 0.5 * (min.x() + max.x());
    add_box(mesh, min, Vector3d(max.x(), max.y(), min.z() + kThick));
    add_box(mesh, min, Vector3d(min.x() + kThick, max.y(), max.z()));
    add_box(mesh, {max.x() - kThick, min.y(), min.z()}, max);
    add_box(mesh, {min.x(), min.y(), max.z() - kThick}, {middle - 0.5 * door, max.y(), max.z()});
    add_box(mesh, {middle + 0.5 * door, min.y(), max.z() - kThick}, max);
}

collision::ObjectId add_object(collision::World& world, TriangleMesh mesh, collision::Detection detection,
                               const collision::Pose& X_world_shape) {
    collision::Object object;
    object.shape = std::make_shared<const collision::MeshCollider>(std::move(mesh));
    object.X_world_shape = X_world_shape;
    object.detection = detection;
    return world.add(std::move(object));
}

collision::ObjectId add_object(collision::World& world, const collision::Shape& shape,
                               const Vector3d& position) {
    collision::Object object;
    object.shape = shape;
    object.X_world_shape.translation = position;
    return world.add(std::move(object));
}

collision::Mat3 turn(const Vector3d& axis, double angle) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

}  // namespace campuswalk::support
