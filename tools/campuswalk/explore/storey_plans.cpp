#include "tools/campuswalk/explore/storey_plans.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/walkspace/node_numbers.h"
#include "tools/campuswalk/explore/island_groups.h"
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

/// The cells of one storey before they are laid out in rows.
struct Cells {
    struct One {
        GridCell cell;
        PlanCell kind = PlanCell::nothing;
        float width = -1.0F;  ///< metres; negative: unknown
    };
    std::vector<One> list;
    GridCell low{1 << 30, 1 << 30};
    GridCell high{-(1 << 30), -(1 << 30)};

    void add(const GridCell& cell, PlanCell kind, float width = -1.0F) {
        list.push_back({cell, kind, width});
        low = {std::min(low.x, cell.x), std::min(low.z, cell.z)};
        high = {std::max(high.x, cell.x), std::max(high.z, cell.z)};
    }
};

std::vector<Cells> cells_by_storey(const engine::WalkReport& report, const GroundWidths& widths) {
    std::vector<Cells> cells(report.storeys.list.size());
    for (const engine::IslandReport& entry : report.islands) {
        if (!is_notable(report, entry)) {
            continue;
        }
        const std::vector<std::size_t> storeys = storeys_of_island(report, entry.island);
        for (std::size_t i = 0; i < storeys.size(); ++i) {
            cells[storeys[i]].add(report.space.grid.cell_at(entry.island.spots[i].at.foot),
                                  PlanCell::unreached);
        }
    }
    std::set<WalkNodeId> trapped;
    for (const engine::Trap& trap : report.traps) {
        trapped.insert(trap.nodes.begin(), trap.nodes.end());
    }
    const engine::NodeNumbers numbers(report.space);
    numbers.for_each([&](const WalkNodeId& id) {
        cells[report.storeys.of(id)].add(report.space.cell_of(id),
                                         trapped.contains(id) ? PlanCell::no_return : PlanCell::reached,
                                         widths.of_nodes.empty() ? -1.0F : widths.of_nodes[numbers(id)]);
    });
    return cells;
}

engine::render::PlanRaster raster_of(const Cells& cells, double size, bool has_widths) {
    engine::render::PlanRaster raster;
    raster.cell_size = size;
    raster.north_west = {cells.low.x * size, cells.low.z * size};
    raster.columns = cells.high.x - cells.low.x + 1;
    raster.rows = cells.high.z - cells.low.z + 1;
    raster.cells.assign(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows),
                        PlanCell::nothing);
    if (has_widths) {
        raster.widths.assign(raster.cells.size(), -1.0F);
    }
    for (const Cells::One& one : cells.list) {
        const auto row = static_cast<std::size_t>(one.cell.z - cells.low.z);
        const auto column = static_cast<std::size_t>(one.cell.x - cells.low.x);
        const std::size_t at = row * static_cast<std::size_t>(raster.columns) + column;
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

/// What the marks lie beyond the cells.
void extend_area(StoreyPlan& plan) {
    for (const auto& point : plan.points) {
        plan.area.extend(point.at);
    }
    for (const auto& finding : plan.findings) {
        plan.area.extend(finding.at);
    }
    const Eigen::Vector2d margin(kMargin, kMargin);
    plan.area = {plan.area.min() - margin, plan.area.max() + margin};
}

}  // namespace

std::vector<StoreyPlan> storey_plans(const scene::Campus& campus, const engine::WalkReport& report,
                                     const std::vector<Finding>& findings, const GroundWidths& widths) {
    const std::vector<Cells> cells = cells_by_storey(report, widths);
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
    if (!plans.empty()) {
        add_marks(report, findings, plans);
    }
    std::ranges::for_each(plans, extend_area);
    return plans;
}

}  // namespace campuswalk::tools::explore
