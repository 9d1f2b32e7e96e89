#pragma once

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "collision/world/world.h"
#include "engine/expect/step_events.h"
#include "engine/script/expectation.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a walk can't exceed on its campus before it comes to a step, whatever happens in it. Bounds are wide:
/// what lies within them may still be impossible.
class WalkBounds {
public:
    /// Both must outlive it.
    WalkBounds(const scene::Campus& campus, const Walk& walk);

    /// From now on of the first `steps` steps, no fewer than before. One more than the walk has is all of it,
    /// with walk.end.
    void come_to(std::size_t steps);

    const scene::Campus& campus() const { return campus_; }
    const AvatarProfile& avatar() const { return walk_.avatar; }
    bool in_step() const { return steps_ <= walk_.steps.size(); }
    bool moves() const { return moves_; }  ///< a step moves the avatar, not only a fall
    /// Whether the avatar detects any object of such a name so.
    bool can_contact(collision::Detection detection, const std::string& glob) const;
    Interval seconds() const;  ///< simulated; may be infinite
    double ticks() const;      ///< at most, likewise
    double metres() const;     ///< of its path, at most, likewise
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
    /// Whether such events can come in this order, as far as the walk's own steps cause them.
    bool can_come(const std::vector<EventPattern>& in_order) const;
    /// Whether such an event can be logged after avatar.fell, with which a walk stops.
    bool can_follow_fall(const EventPattern& event) const;
    /// How far the avatar can be from the target anywhere, and at the walk's start. Who falls out of the
    /// campus isn't anywhere.
    Interval distance(const Target& target) const;
    Interval distance_at_start(const Target& target) const;

private:
    void add(const Step& step);
    bool matches_own(const EventPattern& event, EventKind kind) const;
    /// Whether such an event may come of what the avatar meets, so at any time.
    bool comes_of_campus(const EventPattern& event) const;
    bool can_be_about(EventKind kind, const std::string& glob) const;
    double longest_fall() const;  ///< seconds

    const scene::Campus& campus_;
    const Walk& walk_;
    StepEvents step_events_;
    std::size_t steps_ = 0;
    bool moves_ = false;
    double speed_;               ///< of steps that set none, metres per second
    double fastest_;             ///< horizontally by its own force, metres per second
    double longest_ = 0.0;       ///< seconds that the steps take at most
    double waited_ = 0.0;        ///< seconds of waiting alone
    double highest_jump_ = 0.0;  ///< metres
    collision::Aabb region_;     ///< of foot points, without jumps
    collision::Aabb start_;
};

}  // namespace campuswalk::engine
