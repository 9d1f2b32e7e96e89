#pragma once

#include <cstddef>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/mover/move_context.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

struct MoverState {
    Vec3 foot = Vec3::Zero();     ///< lowest point of the capsule
    double vertical_speed = 0.0;  ///< metres a second, up positive; 0 while grounded
    /// Horizontal, metres a second, of a slide down what is too steep to stand on; 0 while grounded.
    Vec3 drift = Vec3::Zero();
    bool grounded = false;
    double fall_from = 0.0;  ///< greatest height since the ground was left, metres
    /// Height of the point that carries the body, which steps are measured from: on a slope or at an edge it
    /// is above the foot. Ignored where it can't be.
    double carried_at = -1e300;

    /// Into the air, at `speed` upwards; a fall counts from `height`.
    void leave_ground(double speed, double height) {
        grounded = false;
        vertical_speed = speed;
        fall_from = height;
    }

    friend bool operator==(const MoverState&, const MoverState&) = default;
};

/// A solid object beside or above the body; the ground underfoot and steps that are climbed don't count.
struct Touch {
    ObjectId object{};
    double gap = 0.0;  ///< metres between the capsule's surface and the object
};

/// What a move did.
struct MoveTrace {
    std::vector<Vec3> path;       ///< foot points: the start, then the end of every equal part of the tick
    std::vector<Touch> touching;  ///< nearest gap of each object within reach, ascending by object
    bool landed = false;
    double fall_height = 0.0;  ///< when landed, metres
};

/// Moves a capsule through the solid objects of a world: slides along walls, follows the ground, climbs
/// steps, falls. It never ends a move overlapping a solid it didn't overlap before: every straight piece of
/// motion is cleared by separating planes or swept exactly, whatever decided on it. What a move does depends
/// on its arguments alone, not on what went before; a warm move allocates nothing.
class CapsuleMover {
public:
    CapsuleMover(const World& world, const MoverSettings& settings, const QueryFilter& filter);

    /// Puts the body down at `foot`, which must be free (see free_place): on the ground if that is within
    /// `search` metres below, in the air otherwise.
    void place(MoverState& state, const Vec3& foot, double search, QueryStatistics* statistics = nullptr);

    /// One tick: `desired` is the horizontal displacement asked for (y = 0), `seconds` the tick's length.
    void move(MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace,
              QueryStatistics* statistics = nullptr);

    /// Leaves the ground at `speed`, metres a second upwards; the moves that follow rise and fall on the
    /// exact parabola. False, and nothing is changed, unless the body stands.
    bool jump(MoverState& state, double speed) const;

    /// Crouches or stands up: another total height, no less than two radii, on the same foot. False, and
    /// nothing is changed, where there is no head room.
    bool resize(MoverState& state, double height, QueryStatistics* statistics = nullptr);
    double height() const { return settings_.height; }

    /// Call when the filter sees other objects than before.
    void forget();

    /// Fills `trace.touching` for a body at rest.
    void touch(const MoverState& state, MoveTrace& trace, QueryStatistics* statistics = nullptr);

private:
    MoveContext new_context();

    /// A move that came to nothing. It does so again if it is asked for again, and whoever pushes against
    /// something asks in every tick.
    struct RestState {
        bool known = false;
        MoverState state;
        Vec3 desired = Vec3::Zero();
        double seconds = 0.0;
        std::size_t places = 0;  ///< on the trace's path
        std::vector<Touch> touching;
    };
    bool stays(const MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) const;

    MoverSettings settings_;
    double steepest_;  ///< metres up for one metre ahead
    // What is kept from one call to the next: without it an answer takes longer and is the same.
    ContactCache contacts_;
    RestState still_;
    MoveBuffers buffers_;
};

}  // namespace campuswalk::collision
