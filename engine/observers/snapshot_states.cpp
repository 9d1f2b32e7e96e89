#include "engine/observers/snapshot_states.h"

namespace campuswalk::engine {

void SnapshotStates::on_tick(const TickRecord& record) {
    history_.on_tick(record);
    for (const SnapshotStep* step : record.snapshots) {
        states_[step->name] = history_.now();
    }
}

const StateSnapshot* SnapshotStates::taken(const std::string& snapshot) const {
    const auto found = states_.find(snapshot);
    return found == states_.end() ? nullptr : &found->second;
}

}  // namespace campuswalk::engine
