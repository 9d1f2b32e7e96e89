#include "tools/campuswalk/route/route_plan.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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
                                const std::vector<Vec3>& path) {
    engine::ExploreSettings exploration;
    exploration.strides = settings.strides;
    exploration.solids = settings.solids;
    exploration.starts = {path.front()};
    for (const Vec3& foot : path) {
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

Eigen::Vector2d seen_from_above(const Vec3& p) {
    return {p.x(), p.z()};
}

/// The ground around a path, with its ends.
StoreyPlan plan_around(const scene::Campus& campus, const engine::RouteSettings& settings,
                       const std::vector<Vec3>& path, const std::string& from, const std::string& to) {
    collision::Aabb box;
    for (const Vec3& foot : path) {
        box.extend(foot);
    }
    box = box.grown(kAround);
    StoreyPlan plan;
    plan.title = campus.description.name + ", " + from + " to " + to;
    plan.raster = raster_of(ground_around(campus, settings, path), box);
    plan.area.extend(seen_from_above(box.min));
    plan.area.extend(seen_from_above(box.max));
    plan.points.push_back({seen_from_above(path.front()), from, engine::render::PlanPointKind::spawn});
    plan.points.push_back({seen_from_above(path.back()), to});
    return plan;
}

}  // namespace

StoreyPlan route_plan(const scene::Campus& campus, const engine::RouteSettings& settings,
                      const engine::Route& route, const std::string& from, const std::string& to) {
    StoreyPlan plan = plan_around(campus, settings, route.path, from, to);
    plan.subtitle = engine::fixed(route.length(), 1) + " m, climb " + engine::fixed(route.climb(), 2) + " m";
    engine::render::PlanRoute line{{}, from + " to " + to};
    for (const Vec3& foot : route.path) {
        line.points.push_back(seen_from_above(foot));
    }
    plan.routes.push_back(std::move(line));
    return plan;
}

StoreyPlan barrier_plan(const scene::Campus& campus, const engine::RouteSettings& settings,
                        const engine::RouteRequest& request, const engine::UnreachableReason& why,
                        const std::string& from, const std::string& to) {
    std::vector<Vec3> path{request.from.foot};
    if (why.at) {
        path.push_back(*why.at);
    }
    path.push_back(request.to.back().point);
    if (!request.to.back().has_height) {
        path.back().y() = request.from.foot.y();
    }
    StoreyPlan plan = plan_around(campus, settings, path, from, to);
    plan.subtitle = "no route";
    if (why.at) {
        plan.findings.push_back({1, seen_from_above(*why.at), why.text, engine::render::PlanSeverity::error});
    } else {
        plan.subtitle += ": " + why.text;
    }
    return plan;
}

}  // namespace campuswalk::tools::route
