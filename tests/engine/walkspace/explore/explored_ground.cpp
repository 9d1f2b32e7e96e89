#include "tests/engine/walkspace/explore/explored_ground.h"

#include <memory>
#include <utility>

#include "engine/script/avatar_body.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {

using collision::TriangleMesh;
using collision::Vec3;

StrideSettings strides_of(const AvatarProfile& avatar) {
    StrideSettings strides;
    strides.body = mover_settings(avatar);
    strides.walk_speed = avatar.speed;
    strides.run_speed = running_speed(avatar);
    return strides;
}

ExploreSettings explore_from(const Vec3& start, const AvatarProfile& avatar) {
    ExploreSettings settings;
    settings.strides = strides_of(avatar);
    settings.starts = {start};
    return settings;
}

WalkSpace explored(const collision::World& world, const ExploreSettings& settings, std::size_t workers) {
    const WorkerWorlds worlds(world, workers, [] { return std::make_unique<collision::LinearBroadPhase>(); });
    return explore(worlds, settings);
}

WalkSpace explored(const scene::Campus& campus, const Vec3& start, const AvatarProfile& avatar) {
    return explored(campus.world, explore_from(start, avatar));
}

scene::Campus campus_of(TriangleMesh mesh) {
    scene::Campus campus = empty_campus();
    add_object(campus, "ground", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
               Vec3::Zero());
    return campus;
}

scene::Campus varied_ground() {
    TriangleMesh mesh;
    support::add_floor(mesh, 10.0);
    support::add_stairs(mesh, -2.0, -8.0, 2.0, 0.16, 0.3, 10);
    support::add_quad(mesh, {4, 0, 4}, {4, 0, 6}, {7, 1.2, 6}, {7, 1.2, 4});
    support::add_box(mesh, {7, 0, 4}, {9, 1.2, 6});
    support::add_box(mesh, {-10, 0, -1}, {-5.4, 2.5, -0.8});
    support::add_box(mesh, {-4.6, 0, -1}, {-2, 2.5, -0.8});
    support::add_box(mesh, {-8, 0, 3}, {-5, 0.9, 6});
    return campus_of(std::move(mesh));
}

std::vector<WalkNodeId> nodes_of(const WalkSpace& space) {
    std::vector<WalkNodeId> nodes;
    for (std::uint32_t tile = 0; tile < space.tiles.size(); ++tile) {
        for (std::size_t i = 0; i < space.tiles[tile].nodes.size(); ++i) {
            nodes.push_back({tile, static_cast<std::uint16_t>(i)});
        }
    }
    return nodes;
}

std::vector<WalkNodeId> some_nodes(const WalkSpace& space, std::size_t count) {
    std::vector<WalkNodeId> all = nodes_of(space);
    if (all.size() <= count) {
        return all;
    }
    std::vector<WalkNodeId> some;
    for (std::size_t i = 0; i < count; ++i) {
        some.push_back(all[i * (all.size() - 1) / (count - 1)]);
    }
    return some;
}

bool reaches(const WalkSpace& space, const Vec3& foot) {
    return space.find(space.grid.cell_at(foot), foot.y(), 0.2).has_value();
}

}  // namespace campuswalk::engine
