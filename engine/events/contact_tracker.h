#pragma once

#include <vector>

#include "collision/world/broad_phase.h"
#include "engine/events/event.h"

namespace campuswalk::engine {

/// What one detection strategy sees of an object in one tick.
struct ObjectOverlap {
    collision::ObjectId object{};
    bool present = true;    ///< at the end of the tick
    bool met = false;       ///< at some moment of the tick; tells a transit from an absence
    double enter_at = 1.0;  ///< fraction of the tick; used when it was absent before
    double exit_at = 1.0;   ///< fraction of the tick; used when it is absent at the end
};

enum class Phase { exit, enter, stay };

/// A change of an object's contact, or a reminder that it goes on.
struct Transition {
    collision::ObjectId object{};
    Phase phase = Phase::enter;
    double at = 1.0;
    Tick ticks = 0;  ///< exit and stay: since the enter
};

/// Turns sightings into the grammar (ENTER STAY* EXIT)* of every object: one of the paper's collision
/// occurrence, maintaining and vanishing for each strategy.
class ContactTracker {
public:
    /// `stay_ticks`: ticks between two stay transitions of an object.
    explicit ContactTracker(Tick stay_ticks) : stay_ticks_(stay_ticks) {}

    bool active(collision::ObjectId object) const;

    /// `seen` is ascending by object. Objects that are active and not in it exit at the tick's end.
    /// Appends what changed; the caller orders transitions of several strategies.
    void update(Tick tick, const std::vector<ObjectOverlap>& seen, std::vector<Transition>& out);

    /// Everything exits: the avatar was put elsewhere, or the walk ended.
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
