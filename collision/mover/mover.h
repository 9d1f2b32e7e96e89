#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/mover/move_context.h"
#include "collision/mover/open_floor.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

struct MoverState {
    Vec3 foot = Vec3::Zero();     ///< lowest point of the capsule
    double vertical_speed = 0.0;  ///< metres per second, up positive; 0 while grounded
    /// Horizontal velocity of a slide down what is too steep to stand on, metres per second; 0 while
    /// grounded.
    Vec3 slide_velocity = Vec3::Zero();
    bool grounded = false;
    double fall_from = 0.0;  ///< greatest height since the body left the ground, metres
    /// Height of the point that carries the body, which steps are measured from: on a slope or at an edge it
    /// is above the foot. Ignored if it is too high for that.
    double support_y = -1e300;

    /// Makes the body airborne, at `speed` upwards; a fall is measured from `height`.
    void leave_ground(double speed, double height) {
        grounded = false;
        vertical_speed = speed;
        fall_from = height;
    }

    friend bool operator==(const MoverState&, const MoverState&) = default;
};

/// A solid object beside or above the body; not the ground underfoot, nor steps that it climbs.
struct Touch {
    ObjectId object{};
    double gap = 0.0;  ///< metres between the capsule's surface and the object
};

/// What a move did.
struct MoveTrace {
    std::vector<Vec3> path;       ///< of the foot: its start, then the end of each equal part of the tick
    std::vector<Touch> touching;  ///< the smallest gap of each object within reach, ascending by object
    bool landed = false;
    double fall_height = 0.0;  ///< when landed, metres
};

/// A move that changed nothing. The same move from the same state changes nothing again, and a body that is
/// pushed against a wall repeats it every tick.
struct RestingMove {
    bool known = false;
    MoverState state;
    Vec3 desired = Vec3::Zero();
    double seconds = 0.0;
    std::size_t path_points = 0;
    std::vector<Touch> touching;
};

/// What a mover's calls reuse from earlier ones, owned by the caller, one per body. It only saves work: with
/// a fresh cache every result is the same, bit for bit. A mover clears a cache that was filled for another
/// world, filter or body; the caller clears it when objects are added, enabled or disabled, or the world is
/// destroyed.
struct MoverCache {
    ContactCache contacts;
    OpenFloors floors;
    RestingMove resting;
    MoveBuffers buffers;

    /// Drops the contents and retains the memory.
    void clear();
};

/// Moves a capsule through the solid objects of a world: slides along walls, follows the ground, climbs
/// steps, falls. It never ends a move overlapping a solid it didn't overlap before: every straight piece of
/// motion is cleared by separating planes or swept exactly, whatever decided on it. The mover is immutable: a
/// result depends on the arguments alone. With a warm cache, nothing is allocated.
class CapsuleMover {
public:
    /// `world`, and what `filter` points to, must outlive the mover.
    CapsuleMover(const World& world, const MoverSettings& settings, const QueryFilter& filter);

    double height() const { return settings_.height; }

    /// Puts the body down at `foot`, which must be free (see free_place): on the ground if that is within
    /// `search` metres below, in the air otherwise.
    void place(MoverState& state, const Vec3& foot, double search, MoverCache& cache,
               QueryStatistics* statistics = nullptr) const;

    /// One tick: `desired` is the desired horizontal displacement (y = 0), `seconds` the tick's length.
    void move(MoverState& state, const Vec3& desired, double seconds, MoverCache& cache, MoveTrace& trace,
              QueryStatistics* statistics = nullptr) const;

    /// As `move`, but leaves `trace.touching` empty: for bodies of which nobody asks that at each tick.
    void advance(MoverState& state, const Vec3& desired, double seconds, MoverCache& cache, MoveTrace& trace,
                 QueryStatistics* statistics = nullptr) const;

    /// Leaves the ground at `speed`, metres per second upwards; the moves that follow rise and fall on the
    /// exact parabola. False, with nothing changed, unless the body is grounded.
    bool jump(MoverState& state, double speed) const;

    /// The mover of the body once it has crouched or stood up: with another total height, no less than two
    /// radii, on the same foot. None where there is no headroom.
    std::optional<CapsuleMover> resized(const MoverState& state, double height, MoverCache& cache,
                                        QueryStatistics* statistics = nullptr) const;

    /// Fills `trace.touching` for a body at rest.
    void touch(const MoverState& state, MoverCache& cache, MoveTrace& trace,
               QueryStatistics* statistics = nullptr) const;

private:
    MoveContext context_with(MoverCache& cache) const;

    const World* world_;
    MoverSettings settings_;
    QueryFilter filter_;
};

}  // namespace campuswalk::collision
