#pragma once

#include <map>
#include <string>

#include "engine/expect/state_snapshot.h"
#include "engine/record/observer.h"

namespace campuswalk::engine {

/// Keeps how things stood when each snapshot was taken, for what is said of the pictures after the walk.
class SnapshotMoments final : public Observer {
public:
    void frame(const FrameRecord& record) override;

    /// Null for one that wasn't taken.
    const Moment* taken(const std::string& snapshot) const;
    /// The walk's end.
    const Moment& last() const { return chronicle_.now(); }

private:
    Chronicle chronicle_;
    std::map<std::string, Moment> moments_;  ///< by the snapshot's name
};

}  // namespace campuswalk::engine
