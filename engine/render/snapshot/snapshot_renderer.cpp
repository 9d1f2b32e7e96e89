#include "engine/render/snapshot/snapshot_renderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <variant>

#include "engine/events/popup_text.h"
#include "engine/render/geometry/visible_parts.h"
#include "engine/render/overlay/map_grid.h"
#include "engine/render/snapshot/walk_space_lines.h"
#include "scene/campus/building_bounds.h"

namespace campuswalk::engine::render {
namespace {

// Metres from the camera to the eyes: closer, the figure would fill the image.
constexpr double kFigureFrom = 0.9;

constexpr double kBehind = 4.0;          // metres: a person and what is around it
constexpr double kOrbitDistance = 10.0;  // metres, around a point
// Down from the south-west, where the sun is: both visible sides of a building are lit.
constexpr double kOrbitYaw = -0.5235987755982988;
constexpr double kOrbitPitch = -0.4363323129985824;

constexpr double kSteep = 0.999;  // sine of the pitch; beyond, the upper edge of the image gives the heading
constexpr double kLabelledShare = 0.002;  // of the image: buildings that cover less have no label

constexpr double kWalkSpaceRadius = 40.0;   // metres around the avatar
constexpr double kMaxMinimapPlan = 2048.0;  // pixels per side, 16 MB

Eigen::Vector3d eyes_of(const SnapshotRequest& request) {
    return request.avatar.position +
           request.avatar.stature * request.profile.eye_height * Eigen::Vector3d::UnitY();
}

ViewContents contents_of(const SnapshotRequest& request) {
    return std::visit([](const auto& view) { return view.kShows; }, request.camera.view);
}

}  // namespace

SnapshotRenderer::SnapshotRenderer(const scene::Campus& campus, SnapshotSettings settings)
    : campus_(campus),
      settings_(std::move(settings)),
      renderer_(campus.models, settings_.light, make_gl_context(settings_.backend)),
      building_bounds_(scene::building_bounds(campus)) {}

Image SnapshotRenderer::draw(const SnapshotRequest& request) {
    const Viewpoint view = viewpoint(request);
    const std::vector<OverlayLine> lines = lines_of(request);
    const Image image =
        renderer_.draw(view, request.camera.width, request.camera.height, figure(request, view), lines);
    return draw_overlays(image, request, view);
}

std::vector<OverlayLine> SnapshotRenderer::lines_of(const SnapshotRequest& request) const {
    std::vector<OverlayLine> lines =
        overlay_lines(campus_, request.overlays, request.path, request.contacts, request.outlined);
    if (request.overlays.walkspace) {
        WalkSpaceRequest walk_space{
            request.profile, {request.avatar.position}, kWalkSpaceRadius, request.disabled};
        if (request.nobody) {  // what all visitors get to
            walk_space.radius = 0.0;
            walk_space.starts.clear();
            for (const scene::Spawn& spawn : campus_.description.spawns) {
                walk_space.starts.push_back(spawn.position);
            }
        }
        add_walk_space(campus_, walk_space, lines);
    }
    return lines;
}

Channels SnapshotRenderer::draw_channels(const SnapshotRequest& request, const ChannelChoice& choice) {
    const Viewpoint view = viewpoint(request);
    return renderer_.draw_channels(view, request.camera.width, request.camera.height, choice,
                                   figure(request, view));
}

IdImage SnapshotRenderer::draw_ids(const SnapshotRequest& request) {
    return ids_of(draw_channels(request, {.nodes = true}));
}

IdImage SnapshotRenderer::ids_of(const Channels& channels) {
    if (!node_owners_) {
        node_owners_ = find_node_owners(campus_);
    }
    IdImage image{channels.width, channels.height, {}, node_owners_->owners};
    image.ids.reserve(channels.nodes.size());
    for (const std::uint32_t node : channels.nodes) {
        image.ids.push_back(node_owners_->owner_of_node[node]);
    }
    return image;
}

std::optional<Figure> SnapshotRenderer::figure(const SnapshotRequest& request, const Viewpoint& view) {
    if (request.nobody || !contents_of(request).figure) {
        return std::nullopt;
    }
    if ((view.position - eyes_of(request)).norm() <= kFigureFrom) {
        return std::nullopt;
    }
    return Figure{request.avatar, request.profile, request.stride};
}

Image SnapshotRenderer::draw_plan(int width, int height, bool grid) {
    const Viewpoint view = plan(renderer_.bounds(), static_cast<double>(width) / height);
    const Canvas canvas(renderer_.draw(view, width, height), fonts_);
    if (grid) {
        draw_map_grid(canvas, view);
    }
    if (settings_.labels) {
        draw_map_labels(canvas, view, labels());
    }
    if (!grid) {
        draw_scale_bar(canvas, view);
    }
    draw_north_arrow(canvas);
    return canvas.image();
}

Channels SnapshotRenderer::draw_plan_channels(int width, int height, const ChannelChoice& choice) {
    const Viewpoint view = plan(renderer_.bounds(), static_cast<double>(width) / height);
    return renderer_.draw_channels(view, width, height, choice);
}

Image SnapshotRenderer::draw_view(Viewpoint view, int width, int height) {
    keep_near_plane_free(view, static_cast<double>(width) / height, settings_.free_radius);
    return renderer_.draw(view, width, height);
}

template <>
Viewpoint SnapshotRenderer::viewpoint_of(const FirstPersonView&, const SnapshotRequest& request) const {
    return first_person(request.avatar, request.profile, request.camera.fov);
}

template <>
Viewpoint SnapshotRenderer::viewpoint_of(const ThirdPersonView& view, const SnapshotRequest& request) const {
    return third_person(request.avatar, request.profile, request.camera.fov, view.distance.value_or(kBehind),
                        settings_.free_distance);
}

template <>
Viewpoint SnapshotRenderer::viewpoint_of(const TopView& view, const SnapshotRequest& request) const {
    return top(request.avatar.position, view.height_above, request.camera.fov, renderer_.bounds());
}

template <>
Viewpoint SnapshotRenderer::viewpoint_of(const OrbitView& view, const SnapshotRequest& request) const {
    const CameraSettings& camera = request.camera;
    const double yaw = view.yaw.value_or(kOrbitYaw);
    const double pitch = view.pitch.value_or(kOrbitPitch);
    const bool whole = view.around && view.around->building && !view.distance;
    if (whole && !building_bounds_[*view.around->building].empty()) {
        const double aspect = static_cast<double>(camera.width) / camera.height;
        return orbiting(building_bounds_[*view.around->building], aspect, yaw, pitch, camera.fov);
    }
    const Eigen::Vector3d centre =
        view.around ? point_of(*view.around)
                    : Eigen::Vector3d(request.avatar.position + 0.5 * request.avatar.stature *
                                                                    request.profile.height *
                                                                    Eigen::Vector3d::UnitY());
    return orbiting(centre, view.distance.value_or(kOrbitDistance), yaw, pitch, camera.fov);
}

template <>
Viewpoint SnapshotRenderer::viewpoint_of(const FixedView& view, const SnapshotRequest& request) const {
    const Eigen::Vector3d position = view.position.value_or(eyes_of(request));
    if (view.look_at) {
        return looking_at(position, point_of(*view.look_at), request.camera.fov);
    }
    return looking(position, view.yaw.value_or(0.0), view.pitch.value_or(0.0), request.camera.fov);
}

Viewpoint SnapshotRenderer::viewpoint(const SnapshotRequest& request) const {
    Viewpoint view =
        std::visit([&](const auto& any) { return viewpoint_of(any, request); }, request.camera.view);
    keep_near_plane_free(view, static_cast<double>(request.camera.width) / request.camera.height,
                         settings_.free_radius);
    return view;
}

Eigen::Vector3d SnapshotRenderer::point_of(const CameraTarget& target) const {
    if (!target.building) {
        return target.point;
    }
    const scene::Bounds& box = building_bounds_[*target.building];
    return box.empty() ? target.point : box.center();
}

Image SnapshotRenderer::draw_overlays(const Image& image, const SnapshotRequest& request,
                                      const Viewpoint& view) {
    const Canvas canvas(image, fonts_);
    if (contents_of(request).map) {
        if (request.overlays.grid) {
            draw_map_grid(canvas, view);
        }
        draw_path(canvas, view, request.path);
        if (const auto pixel = pixel_of(view, canvas.width(), canvas.height(), request.avatar.position)) {
            draw_heading_arrow(canvas, *pixel, request.avatar.yaw, 13.0 * canvas.scale());
        }
        if (!request.overlays.grid) {
            draw_scale_bar(canvas, view);
        }
        draw_north_arrow(canvas);
    } else if (request.minimap && !renderer_.bounds().empty() && contents_of(request).minimap) {
        draw_minimap(canvas, minimap(), request.avatar);
    }
    const std::vector<PixelRect> frames =
        draw_info_windows(canvas, windows(request, view), settings_.max_windows);
    if (request.overlays.labels) {
        draw_labels(canvas, visible_labels(request), frames);
    }
    if (request.overlays.compass && view.projection == Projection::perspective) {
        const Eigen::Vector3d back = view.R_world_camera.col(2);
        const Eigen::Vector3d up = view.R_world_camera.col(1);
        const Eigen::Vector3d level = std::abs(back.y()) > kSteep ? Eigen::Vector3d(-up) : back;
        draw_compass(canvas, std::atan2(level.x(), level.z()), frames);
    }
    if (!request.caption.empty()) {
        const double s = canvas.scale();
        const TextStyle style = {14.0 * s, true, {1, 1, 1, 1}, 0.0, 1};
        const Eigen::Vector2d size = canvas.text_size(request.caption, style);
        canvas.label(20.0 * s + 0.5 * size.x(), 24.0 * s, request.caption, style);
    }
    return canvas.image();
}

std::vector<InfoWindow> SnapshotRenderer::windows(const SnapshotRequest& request,
                                                  const Viewpoint& view) const {
    std::vector<InfoWindow> all;
    for (auto i = request.open_popups.rbegin(); i != request.open_popups.rend(); ++i) {
        all.push_back(info_window_of(campus_.description.buildings[i->building], *i));
        all.back().anchor = anchor(i->building, request, view);
    }
    return all;
}

std::optional<Eigen::Vector2d> SnapshotRenderer::anchor(std::size_t building, const SnapshotRequest& request,
                                                        const Viewpoint& view) const {
    const scene::Bounds& box = building_bounds_[building];
    const auto inside =
        (view.position.array() > box.min.array()) && (view.position.array() < box.max.array());
    if (box.empty() || inside.all()) {
        return std::nullopt;
    }
    // Two thirds up: above doors and passers-by, below the roof.
    Eigen::Vector3d point = box.center();
    point.y() = box.min.y() + 0.66 * (box.max.y() - box.min.y());
    return pixel_of(view, request.camera.width, request.camera.height, point);
}

std::string SnapshotRenderer::title_of(std::size_t index) const {
    const scene::Building& building = campus_.description.buildings[index];
    const std::string title = popup_title(building, {});
    return title.empty() ? building.id : title;
}

std::vector<MapLabel> SnapshotRenderer::labels() const {
    std::vector<MapLabel> all;
    for (std::size_t i = 0; i < building_bounds_.size(); ++i) {
        const scene::Bounds& box = building_bounds_[i];
        if (!box.empty()) {
            all.push_back({title_of(i), box.center()});
        }
    }
    return all;
}

// One per visible building, at the middle of its visible part, largest part first.
std::vector<PixelLabel> SnapshotRenderer::visible_labels(const SnapshotRequest& request) {
    const IdImage ids = draw_ids(request);
    const auto buildings = static_cast<std::uint32_t>(campus_.description.buildings.size());
    std::vector<std::uint32_t> owners;
    owners.reserve(ids.ids.size());
    for (const std::uint32_t id : ids.ids) {
        owners.push_back(static_cast<std::uint32_t>(ids.owners[id].building.value_or(buildings)));
    }
    auto parts = visible_parts(owners, static_cast<std::size_t>(ids.width), buildings);
    const double least = kLabelledShare * static_cast<double>(owners.size());
    std::erase_if(parts, [&](const VisiblePart& part) { return static_cast<double>(part.pixels) < least; });
    std::ranges::stable_sort(parts, std::greater<>(), &VisiblePart::pixels);
    std::vector<PixelLabel> labels;
    labels.reserve(parts.size());
    for (const VisiblePart& part : parts) {
        labels.push_back({title_of(part.owner), part.deepest});
    }
    return labels;
}

const Minimap& SnapshotRenderer::minimap() {
    if (!minimap_) {
        const scene::Bounds& bounds = renderer_.bounds();
        const double across = std::max(1.0, bounds.max.x() - bounds.min.x());
        const double along = std::max(1.0, bounds.max.z() - bounds.min.z());
        const double scale = std::min(settings_.minimap_detail, kMaxMinimapPlan / std::max(across, along));
        const int width = std::max(16, static_cast<int>(across * scale));
        const int height = std::max(16, static_cast<int>(along * scale));
        const Viewpoint view = plan(bounds, static_cast<double>(width) / height);
        minimap_ = Minimap{renderer_.draw(view, width, height), view, settings_.minimap_radius};
    }
    return *minimap_;
}

}  // namespace campuswalk::engine::render
