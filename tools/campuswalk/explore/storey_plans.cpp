#include "tools/campuswalk/explore/storey_plans.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/walkspace/space/node_numbers.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/explore/storey_marks.h"

namespace campuswalk::tools::explore {

using engine::fixed;
using engine::GridCell;
using engine::WalkNodeId;
using engine::render::PlanCell;
using engine::render::PlanSeverity;
using engine::render::StoreyPlan;

namespace {

/// White around what a plan shows, metres.
constexpr double kMargin = 2.0;

/// What is farther from the ground that is reached than this share of its longer side, and than so many
/// metres, is off the plan, or there would be little room for that ground.
constexpr double kFarShare = 0.5;
constexpr double kLeastFar = 20.0;

double far_from(double longer_side) {
    return std::max(kLeastFar, kFarShare * longer_side);
}

/// A plan of more cells would take too much memory; 25 km² in cells of 0.25 m.
constexpr double kMostCells = 4e8;

/// Columns and rows.
Eigen::Vector2d count_of(const Eigen::AlignedBox2i& cells) {
    return cells.sizes().cast<double>().array() + 1.0;
}

/// The cells of one storey before they are laid out in rows.
struct Cells {
    struct One {
        GridCell cell;
        PlanCell kind = PlanCell::nothing;
        float width = -1.0F;  ///< metres; negative: unknown
    };
    std::vector<One> list;  ///< what is reached before what isn't
    Eigen::AlignedBox2i box;

    void add(const One& one) {
        list.push_back(one);
        box.extend(Eigen::Vector2i(one.cell.x, one.cell.z));
    }
};

void add_reached(const engine::WalkReport& report, const GroundWidths& widths, std::vector<Cells>& storeys) {
    std::set<WalkNodeId> trapped;
    for (const engine::Trap& trap : report.traps) {
        trapped.insert(trap.nodes.begin(), trap.nodes.end());
    }
    const engine::NodeNumbers numbers(report.space);
    numbers.for_each([&](const WalkNodeId& id) {
        storeys[report.storeys.of(id)].add({report.space.cell_of(id),
                                            trapped.contains(id) ? PlanCell::no_return : PlanCell::reached,
                                            widths.of_nodes.empty() ? -1.0F : widths.of_nodes[numbers(id)]});
    });
}

/// The islands that findings are about, as far as they lie near what is reached.
void add_unreached(const engine::WalkReport& report, const std::vector<Finding>& findings,
                   std::vector<Cells>& storeys) {
    std::vector<Eigen::AlignedBox2i> near;
    for (const Cells& cells : storeys) {
        const double size = report.space.grid.cell;
        const int far = static_cast<int>(far_from(size * cells.box.sizes().maxCoeff()) / size);
        const Eigen::AlignedBox2i around(cells.box.min().array() - far, cells.box.max().array() + far);
        near.push_back(count_of(around).prod() > kMostCells ? cells.box : around);
    }
    for (const Finding& finding : findings) {
        for (const std::size_t i : finding.islands) {
            const engine::Island& island = report.islands[i].island;
            const std::vector<std::size_t> storey_of_spot = storeys_of_island(report, island);
            for (std::size_t spot = 0; spot < storey_of_spot.size(); ++spot) {
                const std::size_t storey = storey_of_spot[spot];
                const GridCell cell = report.space.grid.cell_at(island.spots[spot].at.foot);
                if (near[storey].contains(Eigen::Vector2i(cell.x, cell.z))) {
                    storeys[storey].add({cell, PlanCell::unreached});
                }
            }
        }
    }
}

/// What is reached hides what isn't.
engine::render::PlanRaster raster_of(const Cells& cells, double size, bool has_widths) {
    const Eigen::Vector2d count = count_of(cells.box);
    if (count.prod() > kMostCells) {
        throw scene::InputError(
            {"--map", 1, 1}, "plan-too-large",
            "the ground that is reached lies in places too far apart for one plan, within " +
                fixed(size * count.x(), 0) + " m by " + fixed(size * count.y(), 0) +
                " m; start with --from at spawns near each other");
    }
    auto raster = engine::render::PlanRaster::of_nothing(cells.box, size);
    if (has_widths) {
        raster.widths.assign(raster.cells.size(), -1.0F);
    }
    for (const Cells::One& one : cells.list) {
        const std::size_t at = raster.index(Eigen::Vector2i(one.cell.x, one.cell.z) - cells.box.min());
        if (one.kind == PlanCell::unreached && raster.cells[at] != PlanCell::nothing) {
            continue;
        }
        raster.cells[at] = one.kind;
        if (has_widths) {
            raster.widths[at] = one.width;
        }
    }
    return raster;
}

PlanSeverity severity_of(FindingKind kind) {
    switch (kind) {
        case FindingKind::unreached:
            return PlanSeverity::error;
        case FindingKind::island:
        case FindingKind::hot:
            return PlanSeverity::note;
        default:
            return PlanSeverity::warning;
    }
}

void add_marks(const engine::WalkReport& report, const std::vector<Finding>& findings,
               std::vector<StoreyPlan>& plans) {
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        const bool is_spawn = subject.kind == engine::SubjectKind::spawn;
        if (is_spawn || subject.kind == engine::SubjectKind::place) {
            plans[storey_of(report, subject)].points.push_back(
                {{subject.at.x(), subject.at.z()},
                 subject.name,
                 is_spawn ? engine::render::PlanPointKind::spawn : engine::render::PlanPointKind::place});
        }
    }
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& f = findings[i];
        for (const StoreyMark& mark : marks_of(report, f)) {
            plans[mark.storey].findings.push_back(
                {static_cast<int>(i + 1), mark.at, f.subject + ": " + f.text, severity_of(f.kind)});
        }
    }
}

/// The titles of the buildings that stand as high as a storey, on what its plan shows of them; the largest
/// first.
void add_buildings(const scene::Campus& campus, const engine::WalkReport& report,
                   std::vector<StoreyPlan>& plans) {
    std::vector<collision::Aabb> boxes(campus.description.buildings.size());
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const collision::ObjectId id{static_cast<std::uint32_t>(i)};
        const auto& building = campus.objects[i].building;
        if (building && campus.world.object(id).detection == collision::Detection::solid) {
            boxes[*building].extend(campus.world.bounds(id));
        }
    }
    for (std::size_t storey = 0; storey < plans.size(); ++storey) {
        StoreyPlan& plan = plans[storey];
        std::vector<std::pair<double, engine::render::PlanBuilding>> shown;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const engine::Storey& heights = report.storeys.list[storey];
            if (boxes[i].empty() || boxes[i].max.y() < heights.low || boxes[i].min.y() > heights.high) {
                continue;
            }
            const Eigen::AlignedBox2d here =
                plan.area.intersection({Eigen::Vector2d(boxes[i].min.x(), boxes[i].min.z()),
                                        Eigen::Vector2d(boxes[i].max.x(), boxes[i].max.z())});
            const scene::Building& building = campus.description.buildings[i];
            if (!here.isEmpty()) {
                shown.push_back(
                    {here.volume(), {here.center(), building.title.empty() ? building.id : building.title}});
            }
        }
        std::ranges::stable_sort(shown, [](const auto& a, const auto& b) { return a.first > b.first; });
        for (auto& [area, building] : shown) {
            plan.buildings.push_back(std::move(building));
        }
    }
}

/// By marks beside the ground; those far from it stay beyond.
void extend_area(StoreyPlan& plan) {
    const double far = far_from(plan.area.sizes().maxCoeff());
    const Eigen::AlignedBox2d near(plan.area.min().array() - far, plan.area.max().array() + far);
    const auto extend = [&](const auto& mark) {
        if (near.contains(mark.at)) {
            plan.area.extend(mark.at);
        }
    };
    std::ranges::for_each(plan.points, extend);
    std::ranges::for_each(plan.findings, extend);
    const Eigen::Vector2d margin(kMargin, kMargin);
    plan.area = {plan.area.min() - margin, plan.area.max() + margin};
}

}  // namespace

std::vector<StoreyPlan> storey_plans(const scene::Campus& campus, const engine::WalkReport& report,
                                     const std::vector<Finding>& findings, const GroundWidths& widths) {
    if (report.storeys.list.empty()) {
        return {};
    }
    std::vector<Cells> cells(report.storeys.list.size());
    add_reached(report, widths, cells);
    add_unreached(report, findings, cells);
    const double size = report.space.grid.cell;
    std::vector<StoreyPlan> plans(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const engine::Storey& storey = report.storeys.list[i];
        StoreyPlan& plan = plans[i];
        plan.title = campus.description.name;
        if (cells.size() > 1) {  // they are counted from 0, as in the report
            plan.title += ", storey " + std::to_string(i) + " of 0 to " + std::to_string(cells.size() - 1);
        }
        plan.subtitle = fixed(storey.area, 0) + " m² reached, most of it at " + fixed(storey.main_height, 1) +
                        " m (" + fixed(storey.low, 2) + " to " + fixed(storey.high, 2) + " m)";
        plan.raster = raster_of(cells[i], size, !widths.of_nodes.empty());
        plan.narrowest = widths.narrowest;
        plan.widest = widths.widest;
        plan.area.extend(plan.raster.north_west);
        plan.area.extend(plan.raster.north_west +
                         size * Eigen::Vector2d(plan.raster.columns, plan.raster.rows));
    }
    add_marks(report, findings, plans);
    std::ranges::for_each(plans, extend_area);
    add_buildings(campus, report, plans);
    return plans;
}

}  // namespace campuswalk::tools::explore
