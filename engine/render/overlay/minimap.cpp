#include "engine/render/overlay/minimap.h"

#include <numbers>

#include <cairo.h>

#include "engine/render/overlay/map_marks.h"

namespace campuswalk::engine::render {
namespace {

// Pixels in an image 720 high.
constexpr double kRadius = 88.0;
constexpr double kMapMargin = 26.0;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

}  // namespace

void draw_minimap(const Canvas& canvas, const Minimap& minimap, const AvatarState& avatar) {
    if (canvas.height() < kSmallestMinimapImage) {
        return;
    }
    const double s = canvas.scale();
    const double radius = kRadius * s;
    const Eigen::Vector2d centre(kMapMargin * s + radius, canvas.height() - kMapMargin * s - radius);
    const auto here = pixel_of(minimap.view, minimap.plan.width, minimap.plan.height, avatar.position);
    if (!here) {
        return;
    }
    cairo_t* cr = canvas.cairo();
    canvas.set_color({0, 0, 0, 0.28});  // soft edge against bright ground
    cairo_arc(cr, centre.x(), centre.y() + 1.5 * s, radius + 4.0 * s, 0.0, kFullTurn);
    cairo_fill(cr);

    cairo_save(cr);
    cairo_arc(cr, centre.x(), centre.y(), radius, 0.0, kFullTurn);
    cairo_clip_preserve(cr);
    canvas.set_color({0.797, 0.803, 0.791, 1.0});  // beyond the campus, same as on plans
    cairo_fill(cr);
    const double metres_per_plan_pixel = minimap.view.height / minimap.plan.height;
    const double scale = radius / minimap.radius * metres_per_plan_pixel;
    canvas.draw_image(minimap.plan, scale, centre - scale * *here);
    cairo_restore(cr);

    canvas.set_color({1, 1, 1, 0.92});
    cairo_set_line_width(cr, 2.4 * s);
    cairo_arc(cr, centre.x(), centre.y(), radius, 0.0, kFullTurn);
    cairo_stroke(cr);
    canvas.label(centre.x(), centre.y() - radius + 13.0 * s, "N", {12.0 * s, true, {1, 1, 1, 1}, 0.0, 1});
    draw_heading_arrow(canvas, centre, avatar.yaw, 11.0 * s);
}

}  // namespace campuswalk::engine::render
