#include "tools/campuswalk/images/map_image.h"

#include <algorithm>

#include "collision/world/cast.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/map_grid.h"
#include "engine/render/overlay/map_marks.h"

namespace campuswalk::tools {

namespace render = engine::render;
using Eigen::Vector3d;

namespace {

constexpr double kHeightAbove = 26.0;        // metres: 30 m from edge to edge
constexpr double kFov = 1.0471975511965976;  // radians
constexpr double kOverHead = 0.4;            // metres above the head that aren't cut away
constexpr double kHighestCeiling = 60.0;     // metres
constexpr double kArrow = 13.0;              // pixels in an image 720 high

/// Cuts away what is above the avatar's head.
void open_roof(const scene::Campus& campus, const MapState& state, render::Viewpoint& view) {
    const double tall = state.avatar.stature * state.profile.height;
    const Vector3d head = state.avatar.position + tall * Vector3d::UnitY();
    const Vector3d sky = head + kHighestCeiling * Vector3d::UnitY();
    const auto ceiling = collision::cast(campus.world, {collision::Detection::solid, 0}, {head, sky},
                                         collision::Detection::solid);
    if (ceiling) {
        const double clear = std::min(kOverHead, 0.5 * ceiling->fraction * kHighestCeiling);
        view.near_distance = view.position.y() - (head.y() + clear);
    }
}

}  // namespace

render::Image draw_map(const scene::Campus& campus, render::SnapshotRenderer& snapshot_renderer,
                       const MapState& state, int width, int height) {
    render::Viewpoint view =
        render::top(state.avatar.position, kHeightAbove, kFov, snapshot_renderer.bounds());
    open_roof(campus, state, view);
    const render::Fonts fonts;
    const render::Canvas canvas(snapshot_renderer.draw_view(view, width, height), fonts);
    const double s = canvas.scale();
    render::draw_map_grid(canvas, view);
    render::draw_path(canvas, view, state.path);
    if (const auto here = render::pixel_of(view, width, height, state.avatar.position)) {
        render::draw_heading_arrow(canvas, *here, state.avatar.yaw, kArrow * s);
    }
    render::draw_north_arrow(canvas);
    const render::TextStyle style = {16.0 * s, true, {1, 1, 1, 1}, 0.0, 1};
    const Eigen::Vector2d size = canvas.text_size(state.caption, style);
    canvas.label(20.0 * s + 0.5 * size.x(), 26.0 * s, state.caption, style);
    return canvas.image();
}

}  // namespace campuswalk::tools
