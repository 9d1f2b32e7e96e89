#include "engine/render/plan/plan_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <cairo.h>

#include "engine/render/overlay/map_marks.h"
#include "engine/render/plan/plan_marks.h"
#include "engine/render/plan/plan_style.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector2d;

// Pixels.
constexpr double kText = 13.0;
constexpr double kRow = 24.0;
constexpr double kSwatch = 26.0;
constexpr double kRampBar = 120.0;
constexpr double kPointWidth = 14.0;
constexpr double kRouteWidth = 36.0;
constexpr double kGap = 8.0;           // between symbol and text
constexpr double kBetween = 24.0;      // entries of a row
constexpr double kColumn = 340.0;      // at least, of the list
constexpr double kMarkerWidth = 36.0;  // of the list, with room for three digits

constexpr int kMostLines = 8;              // of a finding: the numbers come at the end
constexpr std::size_t kMostFindings = 60;  // listed: the report has them all

TextStyle text_style(double width) {
    return {kText, false, kInk, width, width > 0.0 ? kMostLines : 1};
}

// A box of pixels, each with its colour, and a thin frame.
template <typename ColorAt>
void draw_swatch(const Canvas& canvas, const Vector2d& middle, double width, const ColorAt& color_at) {
    constexpr int kHeight = 14;
    cairo_t* cr = canvas.cairo();
    const Vector2d upper_left(std::floor(middle.x() - 0.5 * width), std::floor(middle.y() - 0.5 * kHeight));
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < static_cast<int>(width); ++x) {
            canvas.set_color(rgba_of(color_at(x, y)));
            cairo_rectangle(cr, upper_left.x() + x, upper_left.y() + y, 1, 1);
            cairo_fill(cr);
        }
    }
    canvas.set_color(kFaintInk);
    cairo_set_line_width(cr, 1.0);
    cairo_rectangle(cr, upper_left.x() + 0.5, upper_left.y() + 0.5, width - 1.0, kHeight - 1.0);
    cairo_stroke(cr);
}

}  // namespace

PlanLegend::PlanLegend(const Canvas& measure, const StoreyPlan& plan, const std::string& grid, double width) {
    add_cells(plan);
    add_marks(plan);
    add(0.0, {}, grid);
    flow(measure, width);
    add_findings(measure, plan, width);
}

void PlanLegend::add(double symbol_width, Symbol symbol, std::string text) {
    entries_.push_back({Vector2d::Zero(), symbol_width, std::move(symbol), std::move(text), 0.0});
}

void PlanLegend::add_cells(const StoreyPlan& plan) {
    const auto add_kind = [&](PlanCell cell, const char* text) {
        if (std::ranges::count(plan.raster.cells, cell) > 0) {
            const auto color = [cell](int x, int y) {
                return cell == PlanCell::no_return && is_on_stripe(x, y) ? kNoReturnStripe : color_of(cell);
            };
            const auto swatch = [color](const Canvas& canvas, const Vector2d& middle) {
                draw_swatch(canvas, middle, kSwatch, color);
            };
            add(kSwatch, swatch, text);
        }
    };
    add_kind(PlanCell::reached, "reached");
    if (!plan.raster.widths.empty()) {
        const auto ramp = [](const Canvas& canvas, const Vector2d& middle) {
            draw_swatch(canvas, middle, kRampBar,
                        [](int x, int) { return width_color(x / (kRampBar - 1.0)); });
        };
        add(kRampBar, ramp,
            "reached, narrower than " + length_text(plan.widest) + ": from " + length_text(plan.narrowest));
    }
    add_kind(PlanCell::no_return, "reached, but no way back");
    add_kind(PlanCell::unreached, "walkable, not reached");
    add_kind(PlanCell::solid, "wall or object");
}

void PlanLegend::add_marks(const StoreyPlan& plan) {
    constexpr std::array kPoints = {std::pair(PlanPointKind::spawn, "spawn"),
                                    std::pair(PlanPointKind::place, "place")};
    for (const auto& [kind, text] : kPoints) {
        const auto is_drawn = [&, kind = kind](const PlanPoint& point) {
            return point.kind == kind && plan.area.contains(point.at);
        };
        if (std::ranges::any_of(plan.points, is_drawn)) {
            const auto symbol = [kind = kind](const Canvas& canvas, const Vector2d& middle) {
                draw_point_symbol(canvas, middle, kind);
            };
            add(kPointWidth, symbol, text);
        }
    }
    const auto is_beyond = [&](const auto& mark) { return !plan.area.contains(mark.at); };
    if (std::ranges::any_of(plan.points, is_beyond) || std::ranges::any_of(plan.findings, is_beyond)) {
        const auto arrow = [](const Canvas& canvas, const Vector2d& middle) {
            draw_arrow_beyond(canvas, middle + Vector2d(0.5 * kPointWidth, 0.0), Vector2d::UnitX());
        };
        add(kPointWidth, arrow, "farther away");
    }
    for (std::size_t i = 0; i < plan.routes.size(); ++i) {
        const auto line = [i](const Canvas& canvas, const Vector2d& middle) {
            const Vector2d half(0.5 * kRouteWidth, 0.0);
            draw_route(canvas, std::array<Vector2d, 2>{middle - half, middle + half}, i);
        };
        add(kRouteWidth, line, plan.routes[i].name.empty() ? "route" : plan.routes[i].name);
    }
    constexpr std::array kSeverities = {std::pair(PlanSeverity::error, "error"),
                                        std::pair(PlanSeverity::warning, "warning"),
                                        std::pair(PlanSeverity::note, "note")};
    for (const auto& [severity, text] : kSeverities) {
        if (std::ranges::count(plan.findings, severity, &PlanFinding::severity) > 0) {
            const auto marker = [severity = severity](const Canvas& canvas, const Vector2d& middle) {
                draw_marker(canvas, middle, severity, 0);
            };
            add(2.0 * kMarker, marker, text);
        }
    }
}

void PlanLegend::flow(const Canvas& measure, double width) {
    Vector2d at = Vector2d::Zero();
    for (Entry& entry : entries_) {
        const double gap = entry.symbol_width > 0.0 ? kGap : 0.0;
        const double wide = entry.symbol_width + gap + measure.text_size(entry.text, text_style(0.0)).x();
        if (at.x() > 0.0 && at.x() + wide > width) {
            at = {0.0, at.y() + kRow};
        }
        entry.at = at;
        at.x() += wide + kBetween;
    }
    height_ = at.y() + kRow;
}

void PlanLegend::add_findings(const Canvas& measure, const StoreyPlan& plan, double width) {
    if (plan.findings.empty()) {
        return;
    }
    const std::size_t listed = std::min(plan.findings.size(), kMostFindings);
    const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(width / kColumn)));
    const std::size_t rows = (listed + columns - 1) / columns;
    const double column_width = width / static_cast<double>(columns);
    const double text_width = column_width - kMarkerWidth - kGap - kBetween;
    const double top = height_ + 10.0;
    Vector2d at(0.0, top);
    for (std::size_t i = 0; i < listed; ++i) {
        if (i > 0 && i % rows == 0) {
            at = {at.x() + column_width, top};
        }
        const PlanFinding& finding = plan.findings[i];
        const auto marker = [severity = finding.severity, number = finding.number](const Canvas& canvas,
                                                                                   const Vector2d& middle) {
            draw_marker(canvas, middle, severity, number);
        };
        entries_.push_back({at, kMarkerWidth, marker, finding.text, text_width});
        at.y() += std::max(kRow + 4.0, measure.text_size(finding.text, text_style(text_width)).y() + 12.0);
        height_ = std::max(height_, at.y());
    }
    if (listed < plan.findings.size()) {
        const std::string rest =
            "and " + std::to_string(plan.findings.size() - listed) + " more: see the report";
        entries_.push_back({{0.0, height_}, 0.0, {}, rest, 0.0});
        height_ += kRow;
    }
}

void PlanLegend::draw(const Canvas& canvas, const Vector2d& upper_left) const {
    const double line = canvas.text_size("x", text_style(0.0)).y();
    for (const Entry& entry : entries_) {
        const Vector2d at = upper_left + entry.at;
        double x = at.x();
        if (entry.symbol) {
            entry.symbol(canvas, {x + 0.5 * entry.symbol_width, at.y() + 0.5 * kRow});
            x += entry.symbol_width + kGap;
        }
        canvas.text(x, at.y() + 0.5 * (kRow - line), entry.text, text_style(entry.text_width));
    }
}

}  // namespace campuswalk::engine::render
