#include "tools/campuswalk/route/route_plan.h"

#include <algorithm>
#include <string>

#include "engine/events/decimals.h"
#include "engine/walkspace/explore.h"
#include "engine/walkspace/worker_worlds.h"

namespace campuswalk::tools::route {

using collision::Vec3;
using engine::render::PlanCell;
using engine::render::StoreyPlan;

namespace {

/// Around the route, and above and below it, metres.
constexpr double kAround = 8.0;
constexpr double kAbove = 1.0;

engine::WalkSpace ground_around(const scene::Campus& campus, const engine::RouteSettings& settings,
                                const engine::Route& route) {
    engine::ExploreSettings exploration;
    exploration.strides = settings.strides;
    exploration.solids = settings.solids;
    exploration.starts = {route.path.front()};
    for (const Vec3& foot : route.path) {
        exploration.within.extend(foot);
    }
    const Vec3 around(kAround, kAbove, kAround);
    exploration.within = {exploration.within.min - around, exploration.within.max + around};
    return engine::explore(engine::WorkerWorlds(campus.world, 1, {}), exploration);
}

engine::render::PlanRaster raster_of(const engine::WalkSpace& space, const collision::Aabb& box) {
    const engine::GridCell low = space.grid.cell_at(box.min);
    const engine::GridCell high = space.grid.cell_at(box.max);
    engine::render::PlanRaster raster;
    raster.cell_size = space.grid.cell;
    raster.north_west = {low.x * space.grid.cell, low.z * space.grid.cell};
    raster.columns = high.x - low.x + 1;
    raster.rows = high.z - low.z + 1;
    raster.cells.assign(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows),
                        PlanCell::nothing);
    for (const engine::WalkTile& tile : space.tiles) {
        for (const engine::WalkNode& node : tile.nodes) {
            const engine::GridCell cell = tile.cell_of(node);
            if (cell.x >= low.x && cell.x <= high.x && cell.z >= low.z && cell.z <= high.z) {
                const auto row = static_cast<std::size_t>(cell.z - low.z);
                raster.cells[row * static_cast<std::size_t>(raster.columns) +
                             static_cast<std::size_t>(cell.x - low.x)] = PlanCell::reached;
            }
        }
    }
    return raster;
}

}  // namespace

StoreyPlan route_plan(const scene::Campus& campus, const engine::RouteSettings& settings,
                      const engine::Route& route, const std::string& from, const std::string& to) {
    collision::Aabb box;
    engine::render::PlanRoute line{{}, from + " to " + to};
    for (const Vec3& foot : route.path) {
        box.extend(foot);
        line.points.emplace_back(foot.x(), foot.z());
    }
    box = box.grown(kAround);
    StoreyPlan plan;
    plan.title = campus.description.name + ", " + from + " to " + to;
    plan.subtitle = engine::fixed(route.length(), 1) + " m, climb " + engine::fixed(route.climb(), 2) + " m";
    plan.raster = raster_of(ground_around(campus, settings, route), box);
    plan.area.extend(Eigen::Vector2d(box.min.x(), box.min.z()));
    plan.area.extend(Eigen::Vector2d(box.max.x(), box.max.z()));
    plan.routes.push_back(std::move(line));
    plan.points.push_back(
        {{route.path.front().x(), route.path.front().z()}, from, engine::render::PlanPointKind::spawn});
    plan.points.push_back({{route.path.back().x(), route.path.back().z()}, to});
    return plan;
}

}  // namespace campuswalk::tools::route
