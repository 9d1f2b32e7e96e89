#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision/world/cast.h"
#include "collision/world/obstacle.h"
#include "engine/render/image/png.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/map_marks.h"
#include "engine/render/passes/light.h"
#include "engine/render/plan/plan_image.h"
#include "engine/render/snapshot/channel_files.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/render/snapshot/snapshot_observer.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/map_image.h"

namespace campuswalk::tools {

using engine::render::SnapshotSettings;

namespace {

/// How this program draws a campus: cameras stay out of its walls. `campus` must outlive the settings.
SnapshotSettings settings_for(const scene::Campus& campus, Backend backend) {
    SnapshotSettings settings;
    settings.backend = backend.value_or(engine::render::RenderingBackend::automatic);
    settings.free_distance = [&campus](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        const auto hit = collision::cast(campus.world, {collision::Detection::solid, 0}, {from, to},
                                         collision::Detection::solid);
        return (to - from).norm() * (hit ? hit->fraction : 1.0);
    };
    settings.free_radius = [&campus, obstacles = std::vector<collision::Obstacle>()](
                               const Eigen::Vector3d& point, double most) mutable {
        const collision::Segment here{point, point};
        collision::gather_obstacles(campus.world, {collision::Detection::solid, 0}, here, most, obstacles);
        for (const collision::Obstacle& obstacle : obstacles) {
            most = std::min(most, collision::closest(here, obstacle).distance);
        }
        return most;
    };
    return settings;
}

/// Draws the marks over a plan of everything.
engine::render::Image with_marks(const engine::render::Image& drawn, const scene::Bounds& bounds,
                                 const PlanMarks& marks) {
    namespace render = engine::render;
    const render::Viewpoint view = render::plan(bounds, static_cast<double>(drawn.width) / drawn.height);
    const render::Fonts fonts;
    const render::Canvas canvas(drawn, fonts);
    const auto pixel_at = [&](const Eigen::Vector3d& point) {
        return render::pixel_of(view, canvas.width(), canvas.height(), point);
    };
    std::vector<render::MapLabel> names;
    for (const PlanMarks::Area& area : marks.areas) {
        render::draw_outline(canvas, view, area.vertices);
        names.push_back({area.name, 0.5 * (area.vertices[0] + area.vertices[2])});
    }
    render::draw_path(canvas, view, marks.path);
    for (const Eigen::Vector3d& doorway : marks.doorways) {
        if (const auto at = pixel_at(doorway)) {
            render::draw_dot(canvas, *at, 8.0 * canvas.scale());
        }
    }
    if (const auto at = pixel_at(marks.visitor.position)) {
        render::draw_heading_arrow(canvas, *at, marks.visitor.yaw, 12.0 * canvas.scale());
    }
    render::draw_map_labels(canvas, view, names);
    return canvas.image();
}

}  // namespace

bool can_draw() {
    return true;
}

std::shared_ptr<engine::render::RendererStore> make_renderers(Backend backend) {
    return std::make_shared<engine::render::RendererStore>(
        [backend](const scene::Campus& campus) { return settings_for(campus, backend); });
}

SnapshotTaker make_snapshot_taker(const scene::Campus& campus, const std::filesystem::path& folder,
                                  engine::render::RendererStore& renderers) {
    auto observer = std::make_unique<engine::render::SnapshotObserver>(campus, folder, renderers);
    const auto* visible_buildings = &observer->visible_buildings();
    return {std::move(observer), visible_buildings};
}

std::vector<std::string> files_of(const std::string& name, const engine::ImageChannels& channels) {
    std::vector<std::string> files = {name + ".png"};
    for (const std::string& ending : engine::render::channel_endings(channels)) {
        files.push_back(name + ending);
    }
    return files;
}

void draw_walked_path(const scene::Campus& campus, const engine::AvatarProfile& avatar,
                      std::span<const Eigen::Vector3d> path, const std::string& caption,
                      const std::filesystem::path& file, Backend backend) {
    constexpr double kStep = 0.05;  // metres: anything shorter has no clear direction
    MapState state;
    state.avatar.position = path.back();
    state.profile = avatar;
    state.path = path;
    state.caption = caption;
    for (std::size_t i = path.size(); i > 0; --i) {
        const Eigen::Vector3d along = path.back() - path[i - 1];
        if (std::hypot(along.x(), along.z()) > kStep) {
            state.avatar.yaw = std::atan2(-along.x(), -along.z());
            break;
        }
    }
    engine::render::SnapshotRenderer snapshot_renderer(campus, settings_for(campus, backend));
    engine::render::write_png(draw_map(campus, snapshot_renderer, state, 1280, 720), file);
}

void draw_campus(const scene::Campus& campus, const CampusImage& image) {
    namespace render = engine::render;
    SnapshotSettings settings = settings_for(campus, image.backend);
    settings.light = render::apply_light(settings.light, image.light);
    settings.labels = settings.labels && !image.marks;
    render::SnapshotRenderer snapshot_renderer(campus, settings);
    render::SnapshotRequest request;
    request.camera = image.camera;
    request.avatar = image.avatar;
    request.nobody = true;
    request.overlays = image.overlays;
    const int width = image.camera.width;
    const int height = image.camera.height;
    const render::Image drawn = image.plan ? snapshot_renderer.draw_plan(width, height, image.overlays.grid)
                                           : snapshot_renderer.draw(request);
    render::write_png(image.marks ? with_marks(drawn, snapshot_renderer.bounds(), *image.marks) : drawn,
                      image.file);
    if (image.channels.any()) {
        const render::ChannelChoice choice = render::choice_of(image.channels);
        render::write_channels(snapshot_renderer, campus,
                               image.plan ? snapshot_renderer.draw_plan_channels(width, height, choice)
                                          : snapshot_renderer.draw_channels(request, choice),
                               image.channels, image.file.parent_path() / image.file.stem());
    }
}

void draw_storey_plans(std::span<const engine::render::StoreyPlan> plans, const std::filesystem::path& file) {
    engine::render::write_png(engine::render::draw_storey_plans(plans), file, engine::render::kPlanSoftware);
}

}  // namespace campuswalk::tools
