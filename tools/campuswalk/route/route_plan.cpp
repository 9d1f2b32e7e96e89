#include "tools/campuswalk/route/route_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "engine/walkspace/explore.h"
#include "engine/walkspace/storeys.h"
#include "engine/walkspace/worker_worlds.h"

namespace campuswalk::tools::route {

using collision::Vec3;
using engine::render::PlanCell;
using engine::render::StoreyPlan;

namespace {

/// Around the route, and above and below it, metres.
constexpr double kAround = 8.0;
constexpr double kAbove = 1.0;
/// Points are on the ground that is nearest to them, within so many metres to the side.
constexpr double kBeside = 1.0;
constexpr double kFarAbove = 1e6;

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

Eigen::Vector2d seen_from_above(const Vec3& p) {
    return {p.x(), p.z()};
}

/// Plans of the ground around a path, of which those are kept that something is drawn on.
class GroundPlans {
public:
    GroundPlans(const scene::Campus& campus, const engine::RouteSettings& settings,
                const std::vector<Vec3>& path, const std::string& title, const std::string& subtitle)
        : space_(ground_around(campus, settings, path)), storeys_(engine::find_storeys(space_)) {
        collision::Aabb box;
        for (const Vec3& foot : path) {
            box.extend(foot);
        }
        box = box.grown(kAround);
        plans_.resize(std::max<std::size_t>(1, storeys_.list.size()));
        is_shown_.assign(plans_.size(), false);
        for (StoreyPlan& plan : plans_) {
            plan.title = title;
            plan.subtitle = subtitle;
            plan.raster = raster_within(box);
            plan.area.extend(seen_from_above(box.min));
            plan.area.extend(seen_from_above(box.max));
        }
        fill_rasters();
    }

    void add_point(const Vec3& foot, const std::string& name, engine::render::PlanPointKind kind) {
        plan_at(foot).points.push_back({seen_from_above(foot), name, kind});
    }
    void add_finding(const Vec3& at, const std::string& text) {
        plan_at(at).findings.push_back({1, seen_from_above(at), text, engine::render::PlanSeverity::error});
    }

    /// On each storey its part there.
    void add_route(const std::vector<Vec3>& path, const std::string& name) {
        for (StoreyPlan& plan : plans_) {
            plan.routes.push_back({name, {}});
        }
        StoreyPlan* plan = &plan_at(path.front());
        plan->routes.back().parts.push_back({seen_from_above(path.front())});
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Vec3 piece = path[i] - path[i - 1];
            const int count = std::max(1, static_cast<int>(std::ceil(piece.norm() / space_.grid.cell)));
            for (int part = 1; part <= count; ++part) {
                const Vec3 foot = path[i - 1] + static_cast<double>(part) / count * piece;
                plan->routes.back().parts.back().push_back(seen_from_above(foot));
                if (StoreyPlan& next = plan_at(foot); &next != plan) {
                    plan = &next;
                    plan->routes.back().parts.push_back({seen_from_above(foot)});
                }
            }
        }
    }

    std::vector<StoreyPlan> shown() && {
        const auto count = std::ranges::count(is_shown_, true);
        std::vector<StoreyPlan> shown;
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            if (is_shown_[i]) {
                shown.push_back(std::move(plans_[i]));
                if (count > 1) {
                    shown.back().title +=
                        ", storey at " + engine::fixed(storeys_.list[i].main_height, 1) + " m";
                }
            }
        }
        return shown;
    }

private:
    engine::render::PlanRaster raster_within(const collision::Aabb& box) const {
        const engine::GridCell low = space_.grid.cell_at(box.min);
        const engine::GridCell high = space_.grid.cell_at(box.max);
        engine::render::PlanRaster raster;
        raster.cell_size = space_.grid.cell;
        raster.north_west = {low.x * space_.grid.cell, low.z * space_.grid.cell};
        raster.columns = high.x - low.x + 1;
        raster.rows = high.z - low.z + 1;
        raster.cells.assign(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows),
                            PlanCell::nothing);
        return raster;
    }

    void fill_rasters() {
        for (std::uint32_t tile = 0; tile < space_.tiles.size(); ++tile) {
            for (std::size_t i = 0; i < space_.tiles[tile].nodes.size(); ++i) {
                const engine::WalkNodeId node{tile, static_cast<std::uint16_t>(i)};
                engine::render::PlanRaster& raster = plans_[storeys_.of(node)].raster;
                const Eigen::Vector2d offset =
                    (seen_from_above(space_.position(node)) - raster.north_west) / raster.cell_size;
                const auto column = static_cast<int>(std::floor(offset.x()));
                const auto row = static_cast<int>(std::floor(offset.y()));
                if (column >= 0 && row >= 0 && column < raster.columns && row < raster.rows) {
                    raster.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
                                 static_cast<std::size_t>(column)] = PlanCell::reached;
                }
            }
        }
    }

    /// Of the storey of the ground that is nearest to a point. From now on it is shown.
    StoreyPlan& plan_at(const Vec3& point) {
        const Vec3 around(kBeside, kFarAbove, kBeside);
        std::size_t storey = 0;
        double least = std::numeric_limits<double>::max();
        for (const engine::WalkNodeId& node : space_.nodes_in({point - around, point + around})) {
            if (const double apart = (space_.position(node) - point).norm(); apart < least) {
                least = apart;
                storey = storeys_.of(node);
            }
        }
        is_shown_[storey] = true;
        return plans_[storey];
    }

    engine::WalkSpace space_;
    engine::Storeys storeys_;
    std::vector<StoreyPlan> plans_;  ///< by storey
    std::vector<bool> is_shown_;     ///< likewise
};

}  // namespace

std::vector<StoreyPlan> route_plans(const scene::Campus& campus, const engine::RouteSettings& settings,
                                    const engine::Route& route, const std::string& from,
                                    const std::string& to) {
    const std::string name = from + " to " + to;
    GroundPlans plans(
        campus, settings, route.path, campus.description.name + ", " + name,
        engine::fixed(route.length(), 1) + " m, climb " + engine::fixed(route.climb(), 2) + " m");
    plans.add_route(route.path, name);
    plans.add_point(route.path.front(), from, engine::render::PlanPointKind::spawn);
    plans.add_point(route.path.back(), to, engine::render::PlanPointKind::place);
    return std::move(plans).shown();
}

std::vector<StoreyPlan> barrier_plans(const scene::Campus& campus, const engine::RouteSettings& settings,
                                      const engine::RouteRequest& request,
                                      const engine::UnreachableReason& why, const std::string& from,
                                      const std::string& to) {
    std::vector<Vec3> path{request.from.foot};
    if (why.at) {
        path.push_back(*why.at);
    }
    path.push_back(request.to.back().point);
    if (!request.to.back().has_height) {
        path.back().y() = request.from.foot.y();
    }
    GroundPlans plans(campus, settings, path, campus.description.name + ", " + from + " to " + to,
                      why.at ? "no route" : "no route: " + why.text);
    plans.add_point(path.front(), from, engine::render::PlanPointKind::spawn);
    plans.add_point(path.back(), to, engine::render::PlanPointKind::place);
    if (why.at) {
        plans.add_finding(*why.at, why.text);
    }
    return std::move(plans).shown();
}

}  // namespace campuswalk::tools::route
