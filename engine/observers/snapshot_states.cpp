#include "engine/observers/snapshot_states.h"

namespace campuswalk::engine {

void SnapshotStates::frame(const TickRecord& record) {
    history_.see(record);
    for (const SnapshotStep* step : record.snapshots) {
        moments_[step->name] = history_.now();
    }
}

const StateSnapshot* SnapshotStates::taken(const std::string& snapshot) const {
    const auto found = moments_.find(snapshot);
    return found == moments_.end() ? nullptr : &found->second;
}

}  // namespace campuswalk::engine
