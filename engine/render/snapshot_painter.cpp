#include "engine/render/snapshot_painter.h"

#include <algorithm>
#include <utility>

#include "engine/events/popup_text.h"
#include "engine/render/building_bounds.h"

namespace campuswalk::engine::render {
namespace {

// Closer to the head than this the figure would fill the picture.
constexpr double kFigureFrom = 0.9;

constexpr double kLargestMinimapPlan = 2048.0;  // pixels a side, 16 MB

}  // namespace

SnapshotPainter::SnapshotPainter(const scene::Campus& campus, SnapshotSettings settings)
    : campus_(campus),
      settings_(std::move(settings)),
      renderer_(campus.models, settings_.light, make_gl_context(settings_.backend)),
      building_bounds_(building_bounds(campus)) {}

Picture SnapshotPainter::draw(const Shot& shot) {
    const Viewpoint view = viewpoint(shot);
    const Picture picture = renderer_.draw(view, shot.camera.width, shot.camera.height, figure(shot, view));
    return draw_over(picture, shot, view);
}

IdPicture SnapshotPainter::draw_ids(const Shot& shot) {
    if (!node_names_) {
        node_names_ = name_nodes(campus_);
    }
    const Viewpoint view = viewpoint(shot);
    Channels channels = renderer_.draw_channels(view, shot.camera.width, shot.camera.height, {.nodes = true},
                                                figure(shot, view));
    for (std::uint32_t& pixel : channels.nodes) {
        pixel = node_names_->name_of_node[pixel];
    }
    return {channels.width, channels.height, std::move(channels.nodes), node_names_->names};
}

std::optional<Figure> SnapshotPainter::figure(const Shot& shot, const Viewpoint& view) {
    if (shot.camera.view != View::third_person) {
        return std::nullopt;
    }
    const Eigen::Vector3d eyes =
        shot.avatar.position + shot.avatar.stature * shot.profile.eye_height * Eigen::Vector3d::UnitY();
    if ((view.position - eyes).norm() <= kFigureFrom) {
        return std::nullopt;
    }
    return Figure{shot.avatar, shot.profile, shot.stride};
}

Picture SnapshotPainter::draw_plan(int width, int height) {
    const Viewpoint view = plan(renderer_.bounds(), static_cast<double>(width) / height);
    const Canvas canvas(renderer_.draw(view, width, height), fonts_);
    if (settings_.labels) {
        draw_map_labels(canvas, view, labels());
    }
    draw_scale_bar(canvas, view);
    draw_north_arrow(canvas);
    return canvas.picture();
}

Picture SnapshotPainter::draw_view(const Viewpoint& view, int width, int height) {
    return renderer_.draw(view, width, height);
}

Viewpoint SnapshotPainter::viewpoint(const Shot& shot) const {
    const CameraSettings& camera = shot.camera;
    switch (camera.view) {
        case View::third_person:
            return third_person(shot.avatar, shot.profile, camera.fov, camera.distance,
                                settings_.free_distance);
        case View::top:
            return top(shot.avatar.position, camera.height_above, camera.fov, renderer_.bounds());
        case View::first_person:
            break;
    }
    return first_person(shot.avatar, shot.profile, camera.fov);
}

Picture SnapshotPainter::draw_over(const Picture& picture, const Shot& shot, const Viewpoint& view) {
    const Canvas canvas(picture, fonts_);
    if (shot.camera.view == View::top) {
        draw_path(canvas, view, shot.path);
        if (const auto pixel = pixel_of(view, canvas.width(), canvas.height(), shot.avatar.position)) {
            draw_heading_arrow(canvas, pixel->x(), pixel->y(), shot.avatar.yaw, 13.0 * canvas.scale());
        }
        draw_scale_bar(canvas, view);
        draw_north_arrow(canvas);
    } else if (settings_.minimap && !renderer_.bounds().empty()) {
        draw_minimap(canvas, minimap(), shot.avatar);
    }
    draw_info_windows(canvas, windows(shot, view), settings_.max_windows);
    if (settings_.caption && !shot.caption.empty()) {
        const double s = canvas.scale();
        const TextStyle style = {14.0 * s, true, {1, 1, 1, 1}, 0.0, 1};
        const Eigen::Vector2d size = canvas.text_size(shot.caption, style);
        canvas.label(20.0 * s + 0.5 * size.x(), 24.0 * s, shot.caption, style);
    }
    return canvas.picture();
}

std::vector<InfoWindow> SnapshotPainter::windows(const Shot& shot, const Viewpoint& view) const {
    std::vector<InfoWindow> all;
    for (auto i = shot.open_popups.rbegin(); i != shot.open_popups.rend(); ++i) {
        all.push_back(info_window_of(campus_.description.buildings[i->building], *i));
        all.back().anchor = anchor(i->building, shot, view);
    }
    return all;
}

std::optional<Eigen::Vector2d> SnapshotPainter::anchor(std::size_t building, const Shot& shot,
                                                       const Viewpoint& view) const {
    const scene::Bounds& box = building_bounds_[building];
    const auto inside =
        (view.position.array() > box.min.array()) && (view.position.array() < box.max.array());
    if (box.empty() || inside.all()) {
        return std::nullopt;
    }
    // Two thirds up: above doors and passers-by, below the roof.
    Eigen::Vector3d point = 0.5 * (box.min + box.max);
    point.y() = box.min.y() + 0.66 * (box.max.y() - box.min.y());
    return pixel_of(view, shot.camera.width, shot.camera.height, point);
}

std::vector<MapLabel> SnapshotPainter::labels() const {
    std::vector<MapLabel> all;
    for (std::size_t i = 0; i < building_bounds_.size(); ++i) {
        const scene::Bounds& box = building_bounds_[i];
        if (!box.empty()) {
            const scene::Building& building = campus_.description.buildings[i];
            const std::string title = popup_title(building, {});
            all.push_back({title.empty() ? building.id : title, 0.5 * (box.min + box.max)});
        }
    }
    return all;
}

const Minimap& SnapshotPainter::minimap() {
    if (!minimap_) {
        const scene::Bounds& bounds = renderer_.bounds();
        const double across = std::max(1.0, bounds.max.x() - bounds.min.x());
        const double along = std::max(1.0, bounds.max.z() - bounds.min.z());
        const double scale =
            std::min(settings_.minimap_detail, kLargestMinimapPlan / std::max(across, along));
        const int width = std::max(16, static_cast<int>(across * scale));
        const int height = std::max(16, static_cast<int>(along * scale));
        const Viewpoint view = plan(bounds, static_cast<double>(width) / height);
        minimap_ = Minimap{renderer_.draw(view, width, height), view, settings_.minimap_radius};
    }
    return *minimap_;
}

}  // namespace campuswalk::engine::render
