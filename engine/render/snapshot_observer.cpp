#include "engine/render/snapshot_observer.h"

#include <array>
#include <cstdio>
#include <utility>

#include "engine/render/png.h"

namespace campuswalk::engine::render {
namespace {

constexpr double kPathSpacing = 0.5;  // metres
constexpr double kStepLength = 0.75;  // metres, of a person's pace: half a turn of the stride
constexpr double kLeap = 2.0;         // metres in a tick: nobody walks so fast, it was a teleport
constexpr double kPi = 3.141592653589793;

std::string caption_of(const std::string& walk, const FrameRecord& record) {
    std::array<char, 40> time{};
    std::snprintf(time.data(), time.size(), "%.2f s", record.time);
    return walk + " \u00b7 " + time.data();
}

}  // namespace

SnapshotObserver::SnapshotObserver(const scene::Campus& campus, std::filesystem::path folder,
                                   SnapshotSettings settings)
    : campus_(campus), folder_(std::move(folder)), settings_(std::move(settings)) {}

SnapshotObserver::~SnapshotObserver() = default;

void SnapshotObserver::begin(const Walk& walk) {
    walk_name_ = walk.name;
    profile_ = walk.avatar;
    path_.clear();
    walked_ = 0.0;
    started_ = false;
}

void SnapshotObserver::follow(const AvatarState& avatar) {
    const double moved = started_ ? (avatar.position - last_position_).norm() : 0.0;
    if (!started_ || moved > kLeap) {
        path_.clear();
    }
    moving_ = moved > 1e-4 && moved <= kLeap;
    walked_ += moving_ ? moved : 0.0;
    if (path_.empty() || (avatar.position - path_.back()).norm() >= kPathSpacing) {
        path_.push_back(avatar.position);
    }
    last_position_ = avatar.position;
    started_ = true;
}

void SnapshotObserver::frame(const FrameRecord& record) {
    follow(record.avatar);
    if (record.snapshots.empty()) {
        return;
    }
    if (!painter_) {
        painter_ = std::make_unique<SnapshotPainter>(campus_, settings_);
    }
    std::vector<Eigen::Vector3d> path = path_;
    path.push_back(record.avatar.position);
    for (const SnapshotStep* step : record.snapshots) {
        Shot shot;
        shot.camera = step->camera;
        shot.avatar = record.avatar;
        shot.profile = profile_;
        shot.stride = moving_ ? kPi * walked_ / kStepLength : 0.0;
        shot.open_popups = record.open_popups;
        shot.path = path;
        shot.caption = caption_of(walk_name_, record);
        const std::filesystem::path file = folder_ / walk_name_ / (step->name + ".png");
        write_png(painter_->draw(shot), file);
        files_.push_back(file);
    }
}

}  // namespace campuswalk::engine::render
