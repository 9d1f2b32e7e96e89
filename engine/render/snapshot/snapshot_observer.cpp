#include "engine/render/snapshot/snapshot_observer.h"

#include <algorithm>
#include <iterator>

#include "engine/render/image/png.h"
#include "engine/render/snapshot/channel_files.h"

namespace campuswalk::engine::render {
void SnapshotObserver::begin(const Walk& walk) {
    requests_.begin(walk);
    visible_buildings_.clear();
    for (const Expectation& expectation : walk.expectations) {
        if (const auto* visible = std::get_if<ExpectVisible>(&expectation)) {
            visible_buildings_[visible->snapshot] = {};
        }
    }
    contacts_.clear();
}

void SnapshotObserver::frame(const TickRecord& record) {
    requests_.follow(record.avatar);
    for (const Event& event : record.events) {
        if (event.kind == EventKind::collision_enter) {
            contacts_.push_back(record.avatar.position);
        }
    }
    for (const SnapshotStep* step : record.snapshots) {
        take(*step, record);
    }
}

void SnapshotObserver::take(const SnapshotStep& step, const TickRecord& record) {
    SnapshotRequest request = requests_.request(record, step.camera);
    request.overlays = step.overlays;
    request.contacts = contacts_;
    SnapshotRenderer& snapshot_renderer = renderers_.of(campus_, requests_.light());
    const std::filesystem::path file = folder_ / (step.name + ".png");
    write_png(snapshot_renderer.draw(request), file);
    files_.push_back(file);
    if (step.channels.any()) {
        const Channels channels = snapshot_renderer.draw_channels(request, choice_of(step.channels));
        std::ranges::move(
            write_channels(snapshot_renderer, campus_, channels, step.channels, folder_ / step.name),
            std::back_inserter(files_));
    }
    if (const auto wanted = visible_buildings_.find(step.name); wanted != visible_buildings_.end()) {
        wanted->second = visible_buildings_of(snapshot_renderer, request);
    }
}

VisibleBuildings SnapshotObserver::visible_buildings_of(SnapshotRenderer& snapshot_renderer,
                                                        const SnapshotRequest& request) const {
    const IdImage ids = snapshot_renderer.draw_ids(request);
    std::vector<std::size_t> pixels_of_name(ids.names.size(), 0);
    for (const std::uint32_t id : ids.ids) {
        ++pixels_of_name[id];
    }
    VisibleBuildings sight;
    sight.pixels = ids.ids.size();
    sight.pixels_of_building.assign(campus_.description.buildings.size(), 0);
    for (std::size_t i = 0; i < ids.names.size(); ++i) {
        if (const auto building = ids.names[i].building) {
            sight.pixels_of_building[*building] += pixels_of_name[i];
        }
    }
    return sight;
}

}  // namespace campuswalk::engine::render
