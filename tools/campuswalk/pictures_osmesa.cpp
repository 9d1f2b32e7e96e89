#include <cmath>

#include "collision/cast.h"
#include "engine/render/png.h"
#include "engine/render/snapshot_observer.h"
#include "tools/campuswalk/map_picture.h"
#include "tools/campuswalk/picture_settings.h"
#include "tools/campuswalk/pictures.h"

namespace campuswalk::tools {

using engine::render::SnapshotSettings;

SnapshotSettings settings_for(const scene::Campus& campus) {
    SnapshotSettings settings;
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

std::unique_ptr<engine::Observer> make_snapshot_taker(const scene::Campus& campus,
                                                      const std::filesystem::path& folder) {
    return std::make_unique<engine::render::SnapshotObserver>(campus, folder, settings_for(campus));
}

void draw_way(const scene::Campus& campus, const engine::AvatarProfile& avatar,
              std::span<const Eigen::Vector3d> way, const std::string& caption,
              const std::filesystem::path& file) {
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
    engine::render::SnapshotPainter painter(campus, settings_for(campus));
    engine::render::write_png(draw_map(campus, painter, moment, 1280, 720), file);
}

void draw_campus(const scene::Campus& campus, const engine::CameraSettings& camera,
                 const engine::AvatarState& avatar, const std::filesystem::path& file) {
    engine::render::SnapshotPainter painter(campus, settings_for(campus));
    engine::render::Shot shot;
    shot.camera = camera;
    shot.avatar = avatar;
    engine::render::write_png(painter.draw(shot), file);
}

void draw_plan(const scene::Campus& campus, int width, int height, const std::filesystem::path& file) {
    engine::render::SnapshotPainter painter(campus, settings_for(campus));
    engine::render::write_png(painter.draw_plan(width, height), file);
}

}  // namespace campuswalk::tools
