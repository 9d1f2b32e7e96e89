#pragma once

#include <map>
#include <string>

#include "engine/expect/state_snapshot.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// Stores the state at each snapshot, for verdicts on the images after the walk.
class SnapshotStates final : public Observer {
public:
    void on_tick(const TickRecord& record) override;

    /// The state at this snapshot; null if it wasn't taken.
    const StateSnapshot* taken(const std::string& snapshot) const;
    /// The state at the walk's end.
    const StateSnapshot& last() const { return history_.now(); }

private:
    StateHistory history_;
    std::map<std::string, StateSnapshot> states_;  ///< by the snapshot's name
};

}  // namespace campuswalk::engine
