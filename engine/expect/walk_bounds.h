#pragma once

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "engine/expect/step_events.h"
#include "engine/script/expectation.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a walk can't exceed on its campus, whatever happens in it. Bounds are wide: what lies within them may
/// still be impossible.
class WalkBounds {
public:
    /// Both must outlive it.
    WalkBounds(const scene::Campus& campus, const Walk& walk);

    /// From now on, what bounds the walk before this step instead of the whole walk.
    void stop_before(std::size_t step);

    const scene::Campus& campus() const { return campus_; }
    const AvatarProfile& avatar() const { return walk_.avatar; }
    bool in_step() const { return steps_ <= walk_.steps.size(); }
    bool moves() const { return moves_; }          ///< a step moves the avatar, not only a fall
    double fastest() const { return fastest_; }    ///< horizontally by its own force, metres per second
    Interval seconds() const { return seconds_; }  ///< simulated; may be infinite
    double ticks() const { return ticks_; }        ///< likewise
    double metres() const { return metres_; }      ///< of its path, at most; may be infinite
    /// How often an event that matches comes.
    Interval times(const EventPattern& event) const;
    /// Whether such events come whatever the visitor meets, and in this order.
    bool are_certain(const std::vector<EventPattern>& in_order) const {
        return step_events_.are_certain(in_order, steps_);
    }
    /// Whether it matches the walk's own event of this kind, which comes in every walk.
    bool is_certain(const EventPattern& event, EventKind kind) const {
        return matches_own(event, kind) && !(in_step() && kind == EventKind::walk_end);
    }
    bool is_only(const EventPattern& event, EventKind kind) const;
    /// Whether such an event can be logged after avatar.fell, with which a walk stops.
    bool can_follow_fall(const EventPattern& event) const;
    /// How far the avatar can be from the target anywhere, and at the walk's start. Who falls out of the
    /// campus isn't anywhere.
    Interval distance(const Target& target) const;
    Interval distance_at_start(const Target& target) const;

private:
    bool matches_own(const EventPattern& event, EventKind kind) const;

    const scene::Campus& campus_;
    const Walk& walk_;
    StepEvents step_events_;
    std::size_t steps_;  ///< one more than the walk has: walk.end comes, too
    bool moves_ = false;
    double fastest_ = 0.0;
    Interval seconds_;
    double ticks_ = 0.0;
    double metres_ = 0.0;
    collision::Aabb region_;  ///< of foot points
    collision::Aabb start_;
};

}  // namespace campuswalk::engine
