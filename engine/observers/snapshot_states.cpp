#include "engine/observers/snapshot_states.h"

namespace campuswalk::engine {

void SnapshotMoments::frame(const FrameRecord& record) {
    chronicle_.see(record);
    for (const SnapshotStep* step : record.snapshots) {
        moments_[step->name] = chronicle_.now();
    }
}

const Moment* SnapshotMoments::taken(const std::string& snapshot) const {
    const auto found = moments_.find(snapshot);
    return found == moments_.end() ? nullptr : &found->second;
}

}  // namespace campuswalk::engine
