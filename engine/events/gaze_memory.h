#pragma once

#include <vector>

#include "collision/world/broad_phase.h"
#include "engine/events/event.h"

namespace campuswalk::engine {

/// What counts as looked at: what the ray of the gaze meets, and for a while what it met before. Without that
/// a pop-up would close and open again with every column that passes between the eyes and the building.
class GazeTracker {
public:
    struct Look {
        collision::ObjectId object{};
        Tick last = 0;          ///< tick in which the ray met it
        double distance = 0.0;  ///< at that tick, metres
    };

    /// An object is looked at no longer in the `hold`th tick without it, at the earliest the first.
    explicit GazeTracker(Tick hold) : hold_(hold < 1 ? 1 : hold) {}

    /// Ends the looks that are over by `tick`.
    void advance(Tick tick);
    /// The ray meets the object.
    void meet(Tick tick, collision::ObjectId object, double distance);
    /// It can't be seen any more.
    void forget(collision::ObjectId object);
    void forget_all() { looks_.clear(); }

    /// Ascending by object.
    const std::vector<Look>& looks() const { return looks_; }
    /// Of the last meeting; 0 for what isn't looked at.
    double distance(collision::ObjectId object) const;

private:
    Tick hold_;
    std::vector<Look> looks_;
};

}  // namespace campuswalk::engine
