#include "tools/campuswalk/suggest/ground_lint.h"

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/broad_phase.h"
#include "engine/events/decimals.h"
#include "scene/campus/bake_mesh.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::tools {

using Eigen::Vector3d;

namespace {

/// What is solid of the model, as one mesh about this origin; empty without triangles that have an area.
collision::World world_of(const UprightModel& upright, const Vector3d& origin) {
    scene::WorldGeometry geometry;
    for (std::size_t n = 0; n < upright.model.nodes.size(); ++n) {
        if (is_intangible(upright, n)) {
            continue;
        }
        scene::for_each_triangle(upright.model, upright.model.nodes[n],
                                 [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                                     const auto first = static_cast<std::uint32_t>(geometry.positions.size());
                                     geometry.positions.insert(geometry.positions.end(), {a, b, c});
                                     geometry.triangles.push_back({first, first + 1, first + 2});
                                 });
    }
    scene::BakedMesh baked = scene::bake_mesh(geometry);
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    if (!baked.mesh.triangles.empty()) {
        collision::Object object;
        object.shape = std::make_shared<const collision::MeshCollider>(std::move(baked.mesh));
        object.X_world_shape.translation = baked.p_world_origin - origin;
        world.add(std::move(object));
    }
    return world;
}

std::string area_text(double square_metres) {
    constexpr double kHectare = 1e4;
    constexpr double kSmall = 100.0;
    return square_metres >= kHectare ? engine::fixed(square_metres / kHectare, 1) + " ha"
                                     : engine::fixed(square_metres, square_metres < kSmall ? 1 : 0) + " m²";
}

}  // namespace

std::optional<engine::GroundCover> ground_of(const UprightModel& upright) {
    constexpr double kRoom = 3.0;  // metres; smaller models are furniture
    const scene::Bounds& bounds = upright.report.bounds;
    const Vector3d size = bounds.max - bounds.min;
    if (bounds.empty() || std::min(size.x(), size.z()) < kRoom) {
        return std::nullopt;
    }
    const Vector3d middle = bounds.center().array().round();  // cells are numbered from the origin on
    const collision::World world = world_of(upright, middle);
    if (world.size() == 0) {
        return std::nullopt;
    }
    const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
    engine::GroundCover ground = engine::measure_ground(
        engine::WorkerWorlds(world, workers, [] { return std::make_unique<collision::LinearBroadPhase>(); }));
    ground.height += middle.y();
    return ground;
}

void lint_ground(const std::optional<engine::GroundCover>& ground, scene::ModelReport& report) {
    if (!ground || !engine::lacks_ground(*ground)) {
        return;
    }
    const std::string most =
        engine::is_roof(*ground)
            ? "a roof, " + ground_text(*ground)
            : ground_text(*ground) + ", " + engine::fixed(100.0 * ground->share, 0) + " % of its footprint";
    report.warnings.push_back(
        {"no-ground", "there is almost no ground to walk on: the most that one can walk about on is " + most +
                          "; add a floor to the model or a solid box to the campus, as --suggest does"});
}

std::string ground_text(const engine::GroundCover& ground) {
    return (ground.is_cut_short ? "about " : "") + area_text(ground.seen) + " at " +
           engine::fixed(ground.height, 2) + " m";
}

}  // namespace campuswalk::tools
