#include "tools/campuswalk/route/route_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/storeys.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::tools::route {

using collision::Vec3;
using engine::render::PlanCell;
using engine::render::StoreyPlan;

namespace {

/// Around the route, and above and below it, metres.
constexpr double kAround = 8.0;
constexpr double kAbove = 1.0;
/// A barrier farther from the start isn't on its plan, metres, nor a goal that far from both.
constexpr double kFarBarrier = 2000.0;
constexpr double kFarGoal = 100.0;
/// Where a route comes back to a storey before it has gone so far, metres, it hasn't left it: storeys
/// interlock on stairs.
constexpr double kLeastPart = 3.0;

engine::WalkSpace ground_in(const scene::Campus& campus, const engine::RouteSettings& settings,
                            const Vec3& start, const collision::Aabb& box) {
    engine::ExploreSettings exploration;
    exploration.strides = settings.strides;
    exploration.solids = settings.solids;
    exploration.starts = {start};
    const Vec3 around(kAround, kAbove, kAround);
    exploration.within = {box.min - around, box.max + around};
    return engine::explore(engine::WorkerWorlds(campus.world, 1, {}), exploration);
}

Eigen::Vector2d seen_from_above(const Vec3& p) {
    return {p.x(), p.z()};
}

/// A point of a route, and where it is.
struct RoutePoint {
    Vec3 foot;
    std::size_t storey = 0;
};

/// Runs that are too short are of the storey before; the last is where the goal is.
void join_short_runs(std::vector<RoutePoint>& points, std::size_t least) {
    std::size_t storey = points.front().storey;
    for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
        for (end = first; end < points.size() && points[end].storey == points[first].storey;) {
            ++end;
        }
        if (end - first >= least || end == points.size()) {
            storey = points[first].storey;
        }
        for (std::size_t i = first; i < end; ++i) {
            points[i].storey = storey;
        }
    }
}

/// Plans of the ground in a box, of which those are kept that something is drawn on.
class GroundPlans {
public:
    /// Explored from `start`.
    GroundPlans(const scene::Campus& campus, const engine::RouteSettings& settings, const Vec3& start,
                const collision::Aabb& box)
        : box_(box.grown(kAround)),
          space_(ground_in(campus, settings, start, box)),
          storeys_(engine::find_storeys(space_)) {
        plans_.resize(std::max<std::size_t>(1, storeys_.list.size()));
        is_shown_.assign(plans_.size(), false);
    }

    void add_point(const Vec3& at, const std::string& name, engine::render::PlanPointKind kind) {
        const std::size_t storey = storey_at(at);
        plan_of(storey).points.push_back({seen_from_above(at), name + height_text(storey, at), kind});
    }
    void add_finding(const Vec3& at, const std::string& text) {
        plan_of(storey_at(at))
            .findings.push_back({1, seen_from_above(at), text, engine::render::PlanSeverity::error});
    }

    /// On each storey its parts there.
    void add_route(const std::vector<Vec3>& path, const std::string& name) {
        std::vector<RoutePoint> points = points_of(path);
        join_short_runs(points, static_cast<std::size_t>(kLeastPart / space_.grid.cell));
        for (StoreyPlan& plan : plans_) {
            plan.routes.push_back({name, {}});
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector2d at = seen_from_above(points[i].foot);
            auto& parts = plan_of(points[i].storey).routes.back().parts;
            if (i == 0 || points[i].storey != points[i - 1].storey) {
                parts.push_back(i == 0 ? std::vector<Eigen::Vector2d>()
                                       : std::vector{seen_from_above(points[i - 1].foot)});
            }
            parts.back().push_back(at);
        }
    }

    std::vector<StoreyPlan> shown(const std::string& title, const std::string& subtitle) && {
        const auto count = std::ranges::count(is_shown_, true);
        std::vector<StoreyPlan> shown;
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            if (!is_shown_[i]) {
                continue;
            }
            StoreyPlan& plan = shown.emplace_back(std::move(plans_[i]));
            plan.title = title;
            if (count > 1) {
                plan.title += ", storey at " + engine::fixed(storeys_.list[i].main_height, 1) + " m";
            }
            plan.subtitle = subtitle;
            plan.raster = raster_of(i);
            plan.area.extend(seen_from_above(box_.min));
            plan.area.extend(seen_from_above(box_.max));
        }
        return shown;
    }

private:
    std::vector<RoutePoint> points_of(const std::vector<Vec3>& path) const {
        std::vector<RoutePoint> points{{path.front(), storey_at(path.front())}};
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Vec3 piece = path[i] - path[i - 1];
            const int count = std::max(1, static_cast<int>(std::ceil(piece.norm() / space_.grid.cell)));
            for (int part = 1; part <= count; ++part) {
                const Vec3 foot = path[i - 1] + static_cast<double>(part) / count * piece;
                points.push_back({foot, storey_at(foot)});
            }
        }
        return points;
    }

    /// Of the ground there or beside it; away from any, of what is as high.
    std::size_t storey_at(const Vec3& at) const {
        constexpr double kSameGround = 0.5;  // metres
        constexpr double kBeside = 2.0;
        if (const auto here = space_.find(space_.grid.cell_at(at), at.y(), kSameGround)) {
            return storeys_.of(*here);
        }
        const auto near = engine::node_near(space_, at, kBeside);
        return near && std::abs(space_.position(*near).y() - at.y()) < engine::kLeastStoreyHeight
                   ? storeys_.of(*near)
                   : engine::storey_at_height(storeys_, at.y());
    }

    /// Where a point isn't on the storey whose plan it is on, as on a floor that nobody gets to.
    std::string height_text(std::size_t storey, const Vec3& at) const {
        const bool is_near =
            storeys_.list.empty() || (at.y() >= storeys_.list[storey].low - engine::kLeastStoreyHeight &&
                                      at.y() <= storeys_.list[storey].high + engine::kLeastStoreyHeight);
        return is_near ? "" : " at " + engine::fixed(at.y(), 1) + " m";
    }

    StoreyPlan& plan_of(std::size_t storey) {
        is_shown_[storey] = true;
        return plans_[storey];
    }

    engine::render::PlanRaster raster_of(std::size_t storey) const {
        const engine::GridCell low = space_.grid.cell_at(box_.min);
        const engine::GridCell high = space_.grid.cell_at(box_.max);
        const Eigen::AlignedBox2i cells(Eigen::Vector2i(low.x, low.z), Eigen::Vector2i(high.x, high.z));
        auto raster = engine::render::PlanRaster::of_nothing(cells, space_.grid.cell);
        for (std::uint32_t tile = 0; tile < space_.tiles.size(); ++tile) {
            for (std::size_t i = 0; i < space_.tiles[tile].nodes.size(); ++i) {
                const engine::WalkNodeId node{tile, static_cast<std::uint16_t>(i)};
                const engine::GridCell cell = space_.cell_of(node);
                const Eigen::Vector2i at(cell.x, cell.z);
                if (storeys_.of(node) == storey && cells.contains(at)) {
                    raster.cells[raster.index(at - cells.min())] = PlanCell::reached;
                }
            }
        }
        return raster;
    }

    collision::Aabb box_;
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
    collision::Aabb box;
    for (const Vec3& foot : route.path) {
        box.extend(foot);
    }
    GroundPlans plans(campus, settings, route.path.front(), box);
    plans.add_route(route.path, name);
    plans.add_point(route.path.front(), from, engine::render::PlanPointKind::spawn);
    plans.add_point(route.path.back(), to, engine::render::PlanPointKind::place);
    return std::move(plans).shown(
        campus.description.name + ", " + name,
        engine::fixed(route.length(), 1) + " m, climb " + engine::fixed(route.climb(), 2) + " m");
}

std::vector<StoreyPlan> barrier_plans(const scene::Campus& campus, const engine::RouteSettings& settings,
                                      const engine::RouteRequest& request, const engine::Reason& why,
                                      const std::string& from, const std::string& to) {
    const Vec3& start = request.from.foot;
    Vec3 goal = request.to.back().point;
    if (!request.to.back().has_height) {
        goal.y() = start.y();
    }
    collision::Aabb box{start, start};
    const auto extend_to = [&](const Vec3& point, double far) {
        if (box.grown(far).overlaps({point, point})) {
            box.extend(point);
        }
    };
    const std::optional<Vec3> barrier = look_at(why);
    if (barrier) {
        extend_to(*barrier, kFarBarrier);
    }
    extend_to(goal, kFarGoal);
    GroundPlans plans(campus, settings, start, box);
    plans.add_point(start, from, engine::render::PlanPointKind::spawn);
    plans.add_point(goal, to, engine::render::PlanPointKind::place);
    if (barrier) {
        plans.add_finding(*barrier, text_of(why));
    }
    return std::move(plans).shown(campus.description.name + ", " + from + " to " + to,
                                  barrier ? "no route" : "no route: " + text_of(why));
}

}  // namespace campuswalk::tools::route
