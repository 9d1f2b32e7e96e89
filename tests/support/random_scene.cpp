#include "tests/support/random_scene.h"

#include <numbers>
#include <utility>

#include "collision/world/placement.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::support {

namespace {

using collision::Object;
using collision::Pose;
using collision::Shape;
using collision::Triangle;
using collision::Vec3;
using collision::World;

/// On or above the ground.
Vec3 somewhere(Dice& dice, double half, double high) {
    const double x = dice.between(-half, half);
    const double y = dice.between(0.0, high);
    return {x, y, dice.between(-half, half)};
}

void add_fence(TriangleMesh& mesh, double half, double high) {
    constexpr double kThick = 0.3;
    const double inner = half - kThick;
    add_box(mesh, {-half, -1, -half}, {half, high, -inner});
    add_box(mesh, {-half, -1, inner}, {half, high, half});
    add_box(mesh, {-half, -1, -half}, {-inner, high, half});
    add_box(mesh, {inner, -1, -half}, {half, high, half});
}

void add_solid(World& world, Dice& dice, const Vec3& at) {
    Object object;
    object.shape = random_solid(dice);
    object.X_world_shape = random_pose(dice, 0.0);
    object.X_world_shape.translation = at;
    world.add(std::move(object));
}

TriangleMesh rolling_ground(Dice& dice) {
    constexpr int kCells = static_cast<int>(kRandomVillageHalf);
    constexpr int kVertices = 2 * kCells + 1;
    std::vector<double> heights;
    heights.reserve(std::size_t{kVertices} * std::size_t{kVertices});
    for (int i = 0; i < kVertices * kVertices; ++i) {
        heights.push_back(dice.between(0.0, 0.35));
    }
    const auto at = [&](int i, int j) {
        const int number = i * kVertices + j;
        return Vec3(i - kCells, heights[static_cast<std::size_t>(number)], j - kCells);
    };
    TriangleMesh mesh;
    for (int i = 0; i + 1 < kVertices; ++i) {
        for (int j = 0; j + 1 < kVertices; ++j) {
            add_quad(mesh, at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), at(i, j));
        }
    }
    return mesh;
}

void add_building(World& world, Dice& dice) {
    const double heading = dice.between(0.0, 2.0 * std::numbers::pi);
    const Pose turned{turn(Vec3::UnitY(), heading), somewhere(dice, kRandomVillageHalf - 3.0, 0.2)};
    TriangleMesh mesh;
    switch (dice.below(4)) {
        case 0: {
            const Vec3 half{dice.between(1.0, 3.0), 0.0, dice.between(1.0, 3.0)};
            add_room(mesh, Vec3(-half.x(), -0.5, -half.z()), Vec3(half.x(), 2.5, half.z()),
                     dice.between(0.65, 1.4));
            if (dice.chance(0.5)) {
                add_box(mesh, Vec3(-half.x(), 2.5, -half.z()), Vec3(half.x(), 2.7, half.z()));
            }
            break;
        }
        case 1:
            add_stairs(mesh, -1.5, -1.0, 2.0, dice.between(0.1, 0.4), dice.between(0.2, 0.4), 8);
            break;
        case 2: {
            const double high = dice.between(0.2, 4.0);
            add_quad(mesh, {-2, 0, 1}, {2, high, 1}, {2, high, -1}, {-2, 0, -1});
            break;
        }
        default: {  // a wall of no thickness with a bend and a lean
            const Vec3 low{2.0, -1.0, dice.between(-2.0, 2.0)};
            const Vec3 high{2.0, 2.0, dice.between(-2.0, 2.0)};
            add_quad(mesh, {-3, -1, 0}, {0, -1, 0}, {0, 2, 0}, {-3, 2, 0});
            add_quad(mesh, {0, -1, 0}, low, high, {0, 2, 0});
        }
    }
    add_object(world, std::move(mesh), collision::Detection::solid, turned);
}

}  // namespace

Shape random_solid(Dice& dice) {
    const double size = dice.between(0.05, 0.8);
    switch (dice.below(4)) {
        case 0:
            return collision::Box{{size, dice.between(0.05, 0.8), dice.between(0.05, 0.8)}};
        case 1:
            return collision::Sphere{size};
        case 2:
            return collision::Capsule{0.6 * size, dice.between(0.0, 0.8)};
        default:
            return collision::Wheel{size, dice.between(0.02, 0.4)};
    }
}

Pose random_pose(Dice& dice, double reach) {
    const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
    const Vec3 axis = dice.in_cube(1.0) + Vec3(0, 0, 1.5);
    return {turn(axis, angle), dice.in_cube(reach)};
}

Triangle random_triangle(Dice& dice, const Vec3& at) {
    const double size = dice.chance(0.3) ? 0.2 : 2.0;
    Triangle t{at, at + dice.in_cube(size), Vec3::Zero()};
    t.c = at + dice.in_cube(size);
    const double kind = dice.between(0.0, 1.0);
    if (kind < 0.05) {
        t.b.y() = t.c.y() = t.a.y();
    } else if (kind < 0.1) {
        t.c.x() = t.b.x();
        t.c.z() = t.b.z();
    } else if (kind < 0.15) {
        t.c = 0.5 * (t.a + t.b);
    } else if (kind < 0.2) {
        t.c = t.a;
    }
    return t;
}

TriangleMesh random_mesh(Dice& dice, int triangles, double reach) {
    TriangleMesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const Triangle t = random_triangle(dice, dice.in_cube(reach));
        add_triangle(mesh, t.a, t.b, t.c);
        if (i > 0 && dice.chance(0.3)) {
            mesh.triangles.back()[0] = mesh.triangles[static_cast<std::size_t>(dice.below(i))][1];
        }
        if (i > 0 && dice.chance(0.05)) {
            mesh.triangles.back() = mesh.triangles[static_cast<std::size_t>(dice.below(i))];
        }
    }
    return mesh;
}

std::unique_ptr<World> make_soup(Dice& dice) {
    auto world = std::make_unique<World>(std::make_unique<collision::LinearBroadPhase>());
    TriangleMesh mesh;
    add_floor(mesh, kSoupHalf);
    add_fence(mesh, kSoupHalf, 9.0);
    for (int i = 0; i < 60; ++i) {
        const Triangle t = random_triangle(dice, somewhere(dice, kSoupHalf - 1.0, 2.0));
        add_triangle(mesh, t.a, t.b, t.c);
    }
    add_object(*world, std::move(mesh));
    for (int i = 0; i < 8; ++i) {
        add_solid(*world, dice, somewhere(dice, kSoupHalf - 1.0, 0.8));
    }
    return world;
}

std::unique_ptr<World> make_random_village(Dice& dice) {
    auto world = std::make_unique<World>(std::make_unique<collision::LinearBroadPhase>());
    add_object(*world, rolling_ground(dice));
    TriangleMesh fence;
    add_fence(fence, kRandomVillageHalf - 0.5, 8.0);
    add_object(*world, std::move(fence));
    for (int i = 0; i < 12; ++i) {
        add_building(*world, dice);
    }
    for (int i = 0; i < 20; ++i) {
        add_solid(*world, dice, somewhere(dice, kRandomVillageHalf - 1.0, 0.8));
    }
    return world;
}

Vec3 random_free_place(const World& world, Dice& dice, double half) {
    const double radius = 0.3;
    const double height = 1.8;
    while (true) {
        const Vec3 candidate = somewhere(dice, half - 1.0, 0.0);
        if (const auto free = free_place(world, {}, candidate, radius, height, 8.0)) {
            return *free;
        }
    }
}

}  // namespace campuswalk::support
