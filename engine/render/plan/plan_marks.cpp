#include "engine/render/plan/plan_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <cairo.h>

#include "engine/render/overlay/free_box.h"
#include "engine/render/plan/plan_style.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSymbol = 6.0;     // half the size of a point's symbol, pixels
constexpr double kNumber = 12.0;    // text of a marker, pixels
constexpr double kArrow = 14.0;     // its length, pixels
constexpr double kName = 12.5;      // text of a point, pixels
constexpr double kRouteLine = 2.6;  // pixels

// Black first: no cell has that.
constexpr std::array<Rgba, 4> kRouteColors = {
    {{0.10, 0.10, 0.10, 1.0}, {0.0, 0.42, 0.38, 1.0}, {0.45, 0.28, 0.05, 1.0}, {0.48, 0.05, 0.45, 1.0}}};

struct MarkerStyle {
    Rgba fill;
    Rgba text;
    double rounding;  // radius in half heights: 1 is round
};

constexpr MarkerStyle style_of(PlanSeverity severity) {
    switch (severity) {
        case PlanSeverity::error:
            return {{0.68, 0.07, 0.14, 1.0}, {1, 1, 1, 1}, 1.0};
        case PlanSeverity::warning:
            return {{1.0, 0.87, 0.25, 1.0}, kInk, 0.35};
        default:
            return {{1, 1, 1, 1}, kInk, 0.35};
    }
}

Vector2d marker_half(const Canvas& canvas, int number) {
    const double text = canvas.text_size(std::to_string(number), {kNumber, true, kInk, 0.0, 1}).x();
    return {std::max(kMarker, 0.5 * text + 5.0), kMarker};
}

// Where a mark is drawn, pixels.
struct MarkSpot {
    Vector2d at;
    Vector2d beyond = Vector2d::Zero();  // if its place is beyond the map: the direction, of length 1

    Vector2d middle() const { return at - 0.5 * kArrow * beyond; }  // of its symbol
};

MarkSpot spot_of(const Vector2d& place, const PlanFrame& frame, const AlignedBox2d& map) {
    const Vector2d pixel = frame.pixel_of(place);
    if (map.contains(pixel)) {
        return {pixel};
    }
    const Vector2d at = pixel.cwiseMax(map.min()).cwiseMin(map.max());
    return {at, (pixel - at).normalized()};
}

// A place's own spot, then places on wider and wider rings around it.
std::vector<Vector2d> ring_shifts() {
    constexpr int kRings = 7;
    constexpr double kApart = 2.3;  // half sizes: boxes on the next ring don't touch
    std::vector<Vector2d> shifts = {Vector2d::Zero()};
    for (int ring = 1; ring <= kRings; ++ring) {
        for (int i = 0; i < 8 * ring; ++i) {
            const double angle = kTurn * (i + 0.5) / (8 * ring);
            shifts.emplace_back(kApart * ring * std::cos(angle), -kApart * ring * std::sin(angle));
        }
    }
    return shifts;
}

AlignedBox2d box_around(const Vector2d& at, const Vector2d& half) {
    return {at - half, at + half};
}

// One box per finding. Adds them to `taken`.
std::vector<AlignedBox2d> place_markers(const Canvas& canvas, const StoreyPlan& plan, const PlanFrame& frame,
                                        const AlignedBox2d& map, std::vector<AlignedBox2d>& taken) {
    const std::vector<Vector2d> shifts = ring_shifts();
    std::vector<AlignedBox2d> boxes;
    for (const PlanFinding& finding : plan.findings) {
        const Vector2d at = spot_of(finding.at, frame, map).at;
        const Vector2d half = marker_half(canvas, finding.number) + Vector2d(2, 2);
        boxes.push_back(free_box(map, at, half, shifts, taken).value_or(box_around(at, half)));
        taken.push_back(boxes.back());
    }
    return boxes;
}

// Right of the symbol, left, above, below.
void draw_name(const Canvas& canvas, const Vector2d& at, const std::string& name, const AlignedBox2d& map,
               std::vector<AlignedBox2d>& taken) {
    const TextStyle style = {kName, true, kInk, 0.0, 1, kHalo};
    const Vector2d half = 0.5 * canvas.text_size(name, style) + Vector2d(1, 0);
    const double x = 1.0 + (kSymbol + 2.0) / half.x();
    const double y = 1.0 + kSymbol / half.y();
    const std::array<Vector2d, 6> shifts = {{{x, 0}, {-x, 0}, {0, -y}, {0, y}, {x, -y}, {x, y}}};
    if (const auto box = free_box(map, at, half, shifts, taken)) {
        taken.push_back(*box);
        canvas.label(box->center().x(), box->center().y(), name, style);
    }
}

// On its spot, or one or two lines above or below.
void draw_building(const Canvas& canvas, const Vector2d& at, const std::string& name, const AlignedBox2d& map,
                   std::vector<AlignedBox2d>& taken) {
    constexpr std::array<double, 5> kLines = {0.0, -1.2, 1.2, -2.4, 2.4};
    const TextStyle style = {kName, false, kFaintInk, 0.0, 1, kHalo};
    const Vector2d half = 0.5 * canvas.text_size(name, style) + Vector2d(1, 0);
    std::array<Vector2d, kLines.size()> shifts;
    std::ranges::transform(kLines, shifts.begin(), [](double lines) { return Vector2d(0.0, 2.0 * lines); });
    if (const auto box = free_box(map, at, half, shifts, taken)) {
        taken.push_back(*box);
        canvas.label(box->center().x(), box->center().y(), name, style);
    }
}

void draw_findings(const Canvas& canvas, const StoreyPlan& plan, const PlanFrame& frame,
                   const AlignedBox2d& map, const std::vector<AlignedBox2d>& boxes) {
    cairo_t* cr = canvas.cairo();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto [at, beyond] = spot_of(plan.findings[i].at, frame, map);
        if (!boxes[i].contains(at)) {
            cairo_move_to(cr, at.x(), at.y());
            cairo_line_to(cr, boxes[i].center().x(), boxes[i].center().y());
            canvas.set_color(kInk);
            cairo_set_line_width(cr, 1.4);
            cairo_stroke(cr);
            if (beyond.isZero()) {
                cairo_arc(cr, at.x(), at.y(), 3.0, 0.0, kTurn);
                cairo_fill(cr);
            } else {
                draw_arrow_beyond(canvas, at, beyond);
            }
        }
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        draw_marker(canvas, boxes[i].center(), plan.findings[i].severity, plan.findings[i].number);
    }
}

}  // namespace

void draw_marker(const Canvas& canvas, const Vector2d& at, PlanSeverity severity, int number) {
    const MarkerStyle style = style_of(severity);
    const Vector2d half = marker_half(canvas, number);
    cairo_t* cr = canvas.cairo();
    const auto shape = [&](double wider) {
        const Vector2d upper_left = at - half - Vector2d(wider, wider);
        const Vector2d size = 2.0 * (half + Vector2d(wider, wider));
        canvas.rounded_rectangle({upper_left.x(), upper_left.y(), size.x(), size.y()},
                                 style.rounding * (kMarker + wider));
    };
    shape(1.5);
    canvas.set_color({1, 1, 1, 0.9});
    cairo_fill(cr);
    shape(0.0);
    canvas.set_color(style.fill);
    cairo_fill_preserve(cr);
    canvas.set_color(kInk);
    cairo_set_line_width(cr, 1.3);
    cairo_stroke(cr);
    if (number != 0) {
        const TextStyle text = {kNumber, true, style.text, 0.0, 1};
        const Vector2d size = canvas.text_size(std::to_string(number), text);
        canvas.text(at.x() - 0.5 * size.x(), at.y() - 0.5 * size.y(), std::to_string(number), text);
    }
}

void draw_point_symbol(const Canvas& canvas, const Vector2d& at, PlanPointKind kind) {
    cairo_t* cr = canvas.cairo();
    cairo_arc(cr, at.x(), at.y(), kSymbol, 0.0, kTurn);
    canvas.set_color({1, 1, 1, 1});
    cairo_fill_preserve(cr);
    canvas.set_color(kInk);
    cairo_set_line_width(cr, 2.0);
    cairo_stroke(cr);
    if (kind == PlanPointKind::spawn) {
        cairo_arc(cr, at.x(), at.y(), 0.55 * kSymbol, 0.0, kTurn);
        cairo_fill(cr);
    }
}

void draw_arrow_beyond(const Canvas& canvas, const Vector2d& tip, const Vector2d& direction) {
    constexpr double kHalfWidth = 6.0;
    const Vector2d aside = kHalfWidth * Vector2d(-direction.y(), direction.x());
    const Vector2d back = tip - kArrow * direction;
    cairo_t* cr = canvas.cairo();
    for (const Vector2d& vertex : {tip, Vector2d(back + aside), Vector2d(back - aside)}) {
        cairo_line_to(cr, vertex.x(), vertex.y());
    }
    cairo_close_path(cr);
    canvas.set_color(kInk);
    cairo_fill(cr);
}

void draw_route(const Canvas& canvas, std::span<const Vector2d> points, std::size_t index) {
    if (points.size() < 2) {
        return;
    }
    cairo_t* cr = canvas.cairo();
    const auto stroke = [&](const Rgba& color, double width) {
        for (const Vector2d& point : points) {
            cairo_line_to(cr, point.x(), point.y());
        }
        cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
        canvas.set_color(color);
        cairo_set_line_width(cr, width);
        cairo_stroke(cr);
    };
    stroke(kHalo, 2.2 * kRouteLine);
    const Rgba& color = kRouteColors[index % kRouteColors.size()];
    stroke(color, kRouteLine);
    const Vector2d along = (points.back() - points[points.size() - 2]).normalized();
    const Vector2d tip =
        points.back() - (kSymbol + 3.0) * along;  // beside the symbol of the place it leads to
    const Vector2d aside(-along.y(), along.x());
    for (const Vector2d& vertex : {Vector2d(tip + 2.0 * along), Vector2d(tip - 9.0 * along + 5.0 * aside),
                                   Vector2d(tip - 9.0 * along - 5.0 * aside)}) {
        cairo_line_to(cr, vertex.x(), vertex.y());
    }
    canvas.set_color(color);
    cairo_fill(cr);
}

void draw_plan_marks(const Canvas& canvas, const StoreyPlan& plan, const PlanFrame& frame,
                     const AlignedBox2d& map) {
    for (std::size_t i = 0; i < plan.routes.size(); ++i) {
        for (const std::vector<Vector2d>& part : plan.routes[i].parts) {
            std::vector<Vector2d> pixels(part.size());
            std::ranges::transform(part, pixels.begin(),
                                   [&](const Vector2d& point) { return frame.pixel_of(point); });
            draw_route(canvas, pixels, i);
        }
    }
    std::vector<AlignedBox2d> taken;
    for (const PlanPoint& point : plan.points) {
        const MarkSpot spot = spot_of(point.at, frame, map);
        taken.push_back(box_around(spot.middle(), {kSymbol, kSymbol}));
        if (spot.beyond.isZero()) {
            draw_point_symbol(canvas, spot.at, point.kind);
        } else {  // at the border, a name has few places
            draw_arrow_beyond(canvas, spot.at, spot.beyond);
            draw_name(canvas, spot.middle(), point.name, map, taken);
        }
    }
    const std::vector<AlignedBox2d> markers = place_markers(canvas, plan, frame, map, taken);
    for (const PlanPoint& point : plan.points) {
        if (const MarkSpot spot = spot_of(point.at, frame, map); spot.beyond.isZero()) {
            draw_name(canvas, spot.at, point.name, map, taken);
        }
    }
    for (const PlanBuilding& building : plan.buildings) {
        draw_building(canvas, frame.pixel_of(building.at), building.name, map, taken);
    }
    draw_findings(canvas, plan, frame, map, markers);
}

}  // namespace campuswalk::engine::render
