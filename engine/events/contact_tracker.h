#pragma once

#include <vector>

#include "collision/world/broad_phase.h"
#include "engine/events/event.h"

namespace campuswalk::engine {

/// What one detection mode finds out about an object in one tick.
struct ObjectOverlap {
    collision::ObjectId object{};
    bool present = true;  ///< overlaps at the end of the tick
    bool touched =
        false;  ///< overlapped at some time in the tick; distinguishes passing through from absence
    double enter_at = 1.0;  ///< fraction of the tick; used if it was absent before
    double exit_at = 1.0;   ///< fraction of the tick; used if it is absent at the end
};

enum class Phase { exit, enter, stay };

/// A change of an object's contact, or a notice that it continues.
struct Transition {
    collision::ObjectId object{};
    Phase phase = Phase::enter;
    double at = 1.0;
    Tick ticks = 0;  ///< exit and stay: since the object was entered
};

/// Turns overlaps into the event grammar (ENTER STAY* EXIT)* of each object: the paper's occurrence,
/// maintaining and vanishing of a collision. Each detection mode has its own tracker.
class ContactTracker {
public:
    /// `stay_ticks`: from one stay transition of an object to the next.
    explicit ContactTracker(Tick stay_ticks) : stay_ticks_(stay_ticks) {}

    bool active(collision::ObjectId object) const;

    /// `seen` is ascending by object. Active objects that aren't in it exit at the end of the tick.
    /// Appends the changes; the caller sorts the transitions of several modes.
    void update(Tick tick, const std::vector<ObjectOverlap>& seen, std::vector<Transition>& out);

    /// All contacts end: the avatar was put elsewhere, or the walk ended.
    void leave_all(Tick tick, std::vector<Transition>& out);

private:
    struct Contact {
        collision::ObjectId object{};
        Tick since = 0;
    };

    Tick stay_ticks_;
    std::vector<Contact> active_;  ///< ascending by object
    std::vector<Contact> next_;
};

}  // namespace campuswalk::engine
