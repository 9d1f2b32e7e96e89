#pragma once

#include <map>
#include <string>

#include "engine/expect/state_snapshot.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// Keeps how things stood when each snapshot was taken, for what is said of the images after the walk.
class SnapshotStates final : public Observer {
public:
    void frame(const TickRecord& record) override;

    /// Null for one that wasn't taken.
    const StateSnapshot* taken(const std::string& snapshot) const;
    /// The walk's end.
    const StateSnapshot& last() const { return history_.now(); }

private:
    StateHistory history_;
    std::map<std::string, StateSnapshot> moments_;  ///< by the snapshot's name
};

}  // namespace campuswalk::engine
