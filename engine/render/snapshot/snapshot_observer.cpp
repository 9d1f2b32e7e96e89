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

void SnapshotObserver::on_tick(const TickRecord& record) {
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
    SnapshotRenderer& renderer = renderers_.of(campus_, requests_.light());
    const std::filesystem::path file = folder_ / (step.name + ".png");
    write_png(renderer.draw(request), file);
    files_.push_back(file);
    if (step.channels.any()) {
        const Channels channels = renderer.draw_channels(request, choice_of(step.channels));
        std::ranges::move(write_channels(renderer, campus_, channels, step.channels, folder_ / step.name),
                          std::back_inserter(files_));
    }
    if (const auto visible = visible_buildings_.find(step.name); visible != visible_buildings_.end()) {
        visible->second = visible_buildings_of(renderer, request);
    }
}

VisibleBuildings SnapshotObserver::visible_buildings_of(SnapshotRenderer& renderer,
                                                        const SnapshotRequest& request) const {
    const IdImage ids = renderer.draw_ids(request);
    std::vector<std::size_t> pixels_of_owner(ids.owners.size(), 0);
    for (const std::uint32_t id : ids.ids) {
        ++pixels_of_owner[id];
    }
    VisibleBuildings visible;
    visible.pixels = ids.ids.size();
    visible.pixels_of_building.assign(campus_.description.buildings.size(), 0);
    for (std::size_t i = 0; i < ids.owners.size(); ++i) {
        if (const auto building = ids.owners[i].building) {
            visible.pixels_of_building[*building] += pixels_of_owner[i];
        }
    }
    return visible;
}

}  // namespace campuswalk::engine::render
