#include "tests/support/village.h"

#include <numbers>

#include "tests/support/mesh_pieces.h"

namespace campuswalk::support {

namespace {

using collision::Object;
using collision::World;

/// Bumps of up to 0.4 m in cells of a metre, by a small hash function instead of random numbers.
double relief(int i, int j) {
    const int mixed = (i * 73 + j * 151 + i * j * 17) % 41;
    return i * i + j * j < 16 ? 0.0 : 0.01 * (mixed < 0 ? mixed + 41 : mixed);
}

TriangleMesh uneven_ground() {
    TriangleMesh mesh;
    const int half = static_cast<int>(kVillageHalf);
    const auto at = [](int i, int j) { return Vector3d(i, relief(i, j), j); };
    for (int i = -half; i < half; ++i) {
        for (int j = -half; j < half; ++j) {
            add_quad(mesh, at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), at(i, j));
        }
    }
    return mesh;
}

TriangleMesh fences() {
    TriangleMesh mesh;
    const double h = kVillageHalf - 0.5;
    add_box(mesh, {-h - 0.2, -1, -h - 0.2}, {h + 0.2, 3, -h});
    add_box(mesh, {-h - 0.2, -1, h}, {h + 0.2, 3, h + 0.2});
    add_box(mesh, {-h - 0.2, -1, -h}, {-h, 3, h});
    add_box(mesh, {h, -1, -h}, {h + 0.2, 3, h});
    return mesh;
}

TriangleMesh garden_walls() {
    TriangleMesh mesh;  // no thickness, each with one front only
    add_quad(mesh, {-6, -1, 5}, {6, -1, 5}, {6, 2, 5}, {-6, 2, 5});
    add_quad(mesh, {6, -1, 5}, {9, -1, 0}, {9, 2, 0}, {6, 2, 5});      // 120 degrees with the first
    add_quad(mesh, {-6, -1, 5}, {-4, -1, 1}, {-4, 2, 1}, {-6, 2, 5});  // about 63
    return mesh;
}

void furnish(World& world) {
    for (int i = 0; i < 6; ++i) {
        add_object(world, collision::Capsule{0.25, 1.5}, {-12.0 + 4.0 * i, 1.5, -7.0 + 0.3 * i});
    }
    Object bench;
    bench.shape = collision::Box{{0.9, 0.25, 0.25}};
    for (int i = 0; i < 4; ++i) {
        bench.X_world_shape = {turn(Vector3d::UnitY(), 0.7 * i), {-10.0 + 5.0 * i, 0.25, 8.0}};
        world.add(bench);
    }
    Object log;
    log.shape = collision::Capsule{0.2, 1.2};
    log.X_world_shape = {turn({0.2, 0.1, 1.0}, 1.4), {3.0, 0.3, -3.0}};
    world.add(log);
    Object fountain;
    fountain.shape = collision::Wheel{1.5, 0.3};
    fountain.X_world_shape = {turn(Vector3d::UnitZ(), std::numbers::pi / 2), {-4.0, 0.2, -2.0}};
    world.add(fountain);
    Object cart_wheel;
    cart_wheel.shape = collision::Wheel{0.5, 0.08};
    cart_wheel.X_world_shape = {turn(Vector3d::UnitY(), 0.6), {2.0, 0.45, 2.5}};
    world.add(cart_wheel);
    add_object(world, collision::Sphere{0.8}, {6.0, 0.5, -5.0});
}

}  // namespace

std::unique_ptr<World> make_village() {
    auto world = std::make_unique<World>(std::make_unique<collision::LinearBroadPhase>());
    add_object(*world, uneven_ground());
    add_object(*world, fences());
    add_object(*world, garden_walls());
    TriangleMesh houses;
    add_room(houses, {-16, -0.5, -16}, {-10, 3, -10}, 0.9);
    add_room(houses, {8, -0.5, -16}, {14, 3, -11}, 1.2);
    add_object(*world, std::move(houses));
    TriangleMesh climbs;
    add_stairs(climbs, 10.0, 8.0, 2.0, 0.3, 0.3, 8);
    add_quad(climbs, {-16, 0, 12}, {-16, 0, 14}, {-10, 2.5, 14}, {-10, 2.5, 12});
    add_object(*world, std::move(climbs));
    furnish(*world);
    return world;
}

}  // namespace campuswalk::support
