#pragma once

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "engine/script/expectation.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Numbers from `least` to `most`.
struct Interval {
    double least = 0.0;
    double most = 0.0;
};

/// What a walk can't exceed on its campus, whatever happens in it. Bounds are wide: what lies within them may
/// still be impossible.
class WalkBounds {
public:
    /// Both must outlive it. `in_step`: of what is expected in the middle of the walk.
    WalkBounds(const scene::Campus& campus, const Walk& walk, bool in_step);

    const scene::Campus& campus() const { return campus_; }
    const AvatarProfile& avatar() const { return walk_.avatar; }
    bool in_step() const { return in_step_; }
    bool moves() const { return moves_; }        ///< a step moves the avatar, not only a fall
    double fastest() const { return fastest_; }  ///< horizontally by its own force, metres per second
    double seconds() const { return seconds_; }  ///< simulated, at most; may be infinite
    double ticks() const { return ticks_; }      ///< likewise
    double metres() const { return metres_; }    ///< of its path, at most; may be infinite
    /// How often an event that matches comes.
    Interval times(const EventPattern& event) const;
    /// Whether it matches the walk's own event of this kind, which comes in every walk.
    bool is_certain(const EventPattern& event, EventKind kind) const {
        return matches_own(event, kind) && !(in_step_ && kind == EventKind::walk_end);
    }
    bool is_only(const EventPattern& event, EventKind kind) const;
    /// How far the avatar can be from the target anywhere, and at the walk's start. Who falls out of the
    /// campus isn't anywhere.
    Interval distance(const Target& target) const;
    Interval distance_at_start(const Target& target) const;

private:
    bool matches_own(const EventPattern& event, EventKind kind) const;

    const scene::Campus& campus_;
    const Walk& walk_;
    bool in_step_;
    bool moves_ = false;
    double fastest_ = 0.0;
    double seconds_ = 0.0;
    double ticks_ = 0.0;
    double metres_ = 0.0;
    collision::Aabb region_;  ///< of foot points
    collision::Aabb start_;
};

}  // namespace campuswalk::engine
