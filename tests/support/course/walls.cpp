#include "tests/support/course/walls.h"

#include <cmath>

#include "tests/support/angles.h"

namespace campuswalk::support {

namespace {

constexpr double kHigh = 3.0;

void add_sheet(TriangleMesh& mesh, double left, double right) {
    add_quad(mesh, {left, 0, 0}, {right, 0, 0}, {right, kHigh, 0}, {left, kHigh, 0});
}

}  // namespace

void add_plain_wall(collision::World& world, double length, const collision::Pose& X_world_wall) {
    TriangleMesh mesh;
    add_sheet(mesh, -length, length);
    add_object(world, std::move(mesh), collision::Detection::solid, X_world_wall);
}

void add_butted_wall(collision::World& world, double length, const collision::Pose& X_world_wall) {
    TriangleMesh mesh;
    for (int i = 0; i < 2.0 * length; ++i) {
        const double x = i - length;
        add_box(mesh, {x, 0, -0.2}, {x + 1.0, kHigh, 0});
    }
    add_object(world, std::move(mesh), collision::Detection::solid, X_world_wall);
}

void add_tessellated_wall(collision::World& world, double length, const collision::Pose& X_world_wall) {
    constexpr double kWide = 0.3;
    constexpr double kRow = 0.25;
    TriangleMesh mesh;
    for (int row = 0; row < 12; ++row) {
        const double low = row * kRow;
        const double start = -length - 0.1 * (row % 3);
        for (int i = 0; start + i * kWide < length; ++i) {
            const double x = start + i * kWide;
            add_quad(mesh, {x, low, 0}, {x + kWide, low, 0}, {x + kWide, low + kRow, 0}, {x, low + kRow, 0});
        }
    }
    add_object(world, std::move(mesh), collision::Detection::solid, X_world_wall);
}

void add_wall_of_sheets(collision::World& world, double length, const collision::Pose& X_world_wall) {
    constexpr double kWide = 0.7;
    for (int i = 0; i * kWide < 2.0 * length; ++i) {
        const double x = i * kWide - length;
        TriangleMesh mesh;
        add_sheet(mesh, x, x + kWide);
        add_object(world, std::move(mesh), collision::Detection::solid, X_world_wall);
    }
}

void add_wall_of_boxes(collision::World& world, double length, const collision::Pose& X_world_wall) {
    collision::Object box;
    box.shape = collision::Box{{1.0, 0.5 * kHigh, 0.25}};
    for (int i = 0; 1.0 + 2.0 * i < 2.0 * length; ++i) {
        const double x = 1.0 + 2.0 * i - length;
        box.X_world_shape = {X_world_wall.rotation, X_world_wall * Vector3d(x, 0.5 * kHigh, -0.25)};
        world.add(box);
    }
}

void add_wedge(TriangleMesh& mesh, double degrees) {
    const double half = radians(0.5 * degrees);
    const Vector3d up(0, kHigh, 0);
    for (const double side : {-1.0, 1.0}) {
        const Vector3d end = 8.0 * Vector3d(-std::cos(half), 0, side * std::sin(half));
        add_quad(mesh, Vector3d::Zero(), end, end + up, up);
    }
}

void add_barrier(TriangleMesh& mesh, double x, double thickness, double half, double low, double high) {
    if (thickness > 0.0) {
        add_box(mesh, {x, low, -half}, {x + thickness, high, half});
    } else {
        add_quad(mesh, {x, low, -half}, {x, low, half}, {x, high, half}, {x, high, -half});
    }
}

void add_doorway(TriangleMesh& mesh, double x, double thickness, double width, double high) {
    const double post = 0.5 * width;
    for (const double side : {-1.0, 1.0}) {
        const double near = side < 0.0 ? -4.0 : post;
        if (thickness > 0.0) {
            add_box(mesh, {x, 0, near}, {x + thickness, kHigh, near + 4.0 - post});
        } else {
            const double far = near + 4.0 - post;
            add_quad(mesh, {x, 0, near}, {x, 0, far}, {x, kHigh, far}, {x, kHigh, near});
        }
    }
    add_barrier(mesh, x, thickness, post, high, kHigh);
}

}  // namespace campuswalk::support
