#include <cmath>

#include "collision/world/cast.h"
#include "engine/render/image/png.h"
#include "engine/render/passes/light.h"
#include "engine/render/snapshot/channel_files.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/render/snapshot/snapshot_observer.h"
#include "tools/campuswalk/map_picture.h"
#include "tools/campuswalk/picture_settings.h"
#include "tools/campuswalk/pictures.h"

namespace campuswalk::tools {

using engine::render::SnapshotSettings;

namespace {

engine::render::RenderingBackend drawn_by(Backend backend) {
    using engine::render::RenderingBackend;
    switch (backend) {
        case Backend::osmesa:
            return RenderingBackend::osmesa;
        case Backend::egl:
            return RenderingBackend::egl;
        case Backend::automatic:
        case Backend::none:
            break;
    }
    return RenderingBackend::automatic;
}

}  // namespace

SnapshotSettings settings_for(const scene::Campus& campus, Backend backend) {
    SnapshotSettings settings;
    settings.backend = drawn_by(backend);
    settings.free_distance = [&campus](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        collision::QueryCounters counters;
        const auto hit = collision::cast(campus.world, {collision::Detection::solid, 0}, {from, to},
                                         collision::Detection::solid, counters);
        return (to - from).norm() * (hit ? hit->fraction : 1.0);
    };
    return settings;
}

bool can_draw() {
    return true;
}

std::shared_ptr<engine::render::PainterStore> make_painters(Backend backend) {
    return std::make_shared<engine::render::PainterStore>(
        [backend](const scene::Campus& campus) { return settings_for(campus, backend); });
}

namespace {

class Taker final : public SnapshotTaker {
public:
    Taker(const scene::Campus& campus, const std::filesystem::path& folder,
          engine::render::PainterStore& painters)
        : taker_(campus, folder, painters) {}

    void begin(const engine::Walk& walk) override { taker_.begin(walk); }
    void frame(const engine::FrameRecord& record) override { taker_.frame(record); }
    void end() override { taker_.end(); }
    const engine::render::SnapshotSights& sights() const override { return taker_.sights(); }

private:
    engine::render::SnapshotObserver taker_;
};

}  // namespace

std::unique_ptr<SnapshotTaker> make_snapshot_taker(const scene::Campus& campus,
                                                   const std::filesystem::path& folder,
                                                   engine::render::PainterStore& painters) {
    return std::make_unique<Taker>(campus, folder, painters);
}

std::vector<std::string> files_of(const engine::SnapshotStep& step) {
    std::vector<std::string> files = {step.name + ".png"};
    for (const std::string& ending : engine::render::channel_endings(step.channels)) {
        files.push_back(step.name + ending);
    }
    return files;
}

void draw_way(const scene::Campus& campus, const engine::AvatarProfile& avatar,
              std::span<const Eigen::Vector3d> way, const std::string& caption,
              const std::filesystem::path& file, Backend backend) {
    constexpr double kStep = 0.05;  // metres: less has no direction
    MapMoment moment;
    moment.avatar.position = way.back();
    moment.profile = avatar;
    moment.path = way;
    moment.caption = caption;
    for (std::size_t i = way.size(); i > 0; --i) {
        const Eigen::Vector3d along = way.back() - way[i - 1];
        if (std::hypot(along.x(), along.z()) > kStep) {
            moment.avatar.yaw = std::atan2(-along.x(), -along.z());
            break;
        }
    }
    engine::render::SnapshotPainter painter(campus, settings_for(campus, backend));
    engine::render::write_png(draw_map(campus, painter, moment, 1280, 720), file);
}

void draw_campus(const scene::Campus& campus, const CampusPicture& picture) {
    namespace render = engine::render;
    SnapshotSettings settings = settings_for(campus, picture.backend);
    settings.light = render::lit(settings.light, picture.light);
    render::SnapshotPainter painter(campus, settings);
    render::Shot shot;
    shot.camera = picture.camera;
    shot.avatar = picture.avatar;
    shot.nobody = true;
    shot.overlays = picture.overlays;
    const int width = picture.camera.width;
    const int height = picture.camera.height;
    render::write_png(picture.plan ? painter.draw_plan(width, height) : painter.draw(shot), picture.file);
    if (picture.channels.any()) {
        const render::ChannelChoice choice = render::choice_of(picture.channels);
        render::write_channels(painter, campus,
                               picture.plan ? painter.draw_plan_channels(width, height, choice)
                                            : painter.draw_channels(shot, choice),
                               picture.channels, picture.file.parent_path() / picture.file.stem());
    }
}

}  // namespace campuswalk::tools
