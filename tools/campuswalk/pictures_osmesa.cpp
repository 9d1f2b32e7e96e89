#include "collision/cast.h"
#include "engine/render/png.h"
#include "engine/render/snapshot_observer.h"
#include "engine/render/snapshot_painter.h"
#include "tools/campuswalk/pictures.h"

namespace campuswalk::tools {

using engine::render::SnapshotSettings;

namespace {

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

}  // namespace

bool can_draw() {
    return true;
}

std::unique_ptr<engine::Observer> make_snapshot_taker(const scene::Campus& campus,
                                                      const std::filesystem::path& folder) {
    return std::make_unique<engine::render::SnapshotObserver>(campus, folder, settings_for(campus));
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
