#include "engine/render/snapshot_observer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <utility>

#include "engine/render/channel_files.h"
#include "engine/render/light.h"
#include "engine/render/png.h"

namespace campuswalk::engine::render {
namespace {

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
    light_ = walk.light;
    painter_.reset();  // another walk may have another light
    trail_.clear();
    sights_.clear();
    for (const Expectation& expectation : walk.expectations) {
        if (const auto* visible = std::get_if<ExpectVisible>(&expectation)) {
            sights_[visible->snapshot] = {};
        }
    }
    contacts_.clear();
}

void SnapshotObserver::frame(const FrameRecord& record) {
    trail_.follow(record.avatar);
    for (const Event& event : record.events) {
        if (event.kind == EventKind::collision_enter) {
            contacts_.push_back(record.avatar.position);
        }
    }
    if (record.snapshots.empty()) {
        return;
    }
    if (!painter_) {
        SnapshotSettings settings = settings_;
        settings.light = lit(settings_.light, light_);
        painter_ = std::make_unique<SnapshotPainter>(campus_, settings);
    }
    const std::vector<Eigen::Vector3d> path = trail_.path();
    for (const SnapshotStep* step : record.snapshots) {
        Shot shot;
        shot.camera = step->camera;
        shot.avatar = record.avatar;
        shot.profile = profile_;
        shot.stride = trail_.stride();
        shot.open_popups = record.open_popups;
        shot.path = path;
        shot.overlays = step->overlays;
        shot.contacts = contacts_;
        shot.caption = caption_of(walk_name_, record);
        const std::filesystem::path file = folder_ / (step->name + ".png");
        write_png(painter_->draw(shot), file);
        files_.push_back(file);
        if (step->channels.any()) {
            const Channels channels = painter_->draw_channels(shot, choice_of(step->channels));
            std::ranges::move(
                write_channels(*painter_, campus_, channels, step->channels, folder_ / step->name),
                std::back_inserter(files_));
        }
        if (const auto wanted = sights_.find(step->name); wanted != sights_.end()) {
            wanted->second = sight_of(shot);
        }
    }
}

SnapshotSight SnapshotObserver::sight_of(const Shot& shot) {
    const IdPicture ids = painter_->draw_ids(shot);
    std::vector<std::size_t> pixels_of_name(ids.names.size(), 0);
    for (const std::uint32_t id : ids.ids) {
        ++pixels_of_name[id];
    }
    SnapshotSight sight;
    sight.pixels = ids.ids.size();
    sight.of_building.assign(campus_.description.buildings.size(), 0);
    for (std::size_t i = 0; i < ids.names.size(); ++i) {
        if (const auto building = ids.names[i].building) {
            sight.of_building[*building] += pixels_of_name[i];
        }
    }
    return sight;
}

}  // namespace campuswalk::engine::render
