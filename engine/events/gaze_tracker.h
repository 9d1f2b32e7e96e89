#pragma once

#include <vector>

#include "collision/world/broad_phase.h"
#include "engine/events/event.h"

namespace campuswalk::engine {

/// The objects that count as looked at: the one that the gaze's ray hits, and for a while those that it hit
/// before. Otherwise a pop-up would close and reopen with every column between the eyes and the building.
class GazeTracker {
public:
    struct Look {
        collision::ObjectId object{};
        Tick last = 0;          ///< the last tick in which the ray hit it
        double distance = 0.0;  ///< in that tick, metres
    };

    /// A look ends in the `hold`th tick in which the ray misses the object; `hold` is at least 1.
    explicit GazeTracker(Tick hold) : hold_(hold < 1 ? 1 : hold) {}

    /// Ends the looks that have expired by `tick`.
    void advance(Tick tick);
    /// The ray hits the object.
    void hit(Tick tick, collision::ObjectId object, double distance);
    /// The object has become invisible.
    void forget(collision::ObjectId object);
    void forget_all() { looks_.clear(); }

    /// Ascending by object.
    const std::vector<Look>& looks() const { return looks_; }
    /// At the last hit, metres; 0 for an object that isn't looked at.
    double distance(collision::ObjectId object) const;

private:
    Tick hold_;
    std::vector<Look> looks_;
};

}  // namespace campuswalk::engine
