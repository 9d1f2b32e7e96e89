#pragma once

#include <cstdint>
#include <vector>

#include "collision/counters.h"
#include "collision/obstacle.h"
#include "collision/world.h"

namespace campuswalk::collision {

/// The body that is moved: an upright capsule, metres.
struct MoverSettings {
    double height = 1.8;  ///< total
    double radius = 0.3;
    double step_height = 0.3;            ///< the highest edge it rolls over
    double min_up = 0.6427876096865393;  ///< cosine of the steepest slope it walks on (50°)
    double skin = 0.02;                  ///< gap kept to flat walls
    double gravity = 9.81;               ///< metres a second squared
};

struct MoverState {
    Vec3 foot = Vec3::Zero();     ///< lowest point of the capsule
    double vertical_speed = 0.0;  ///< metres a second, up positive; 0 while grounded
    bool grounded = false;
    double fall_from = 0.0;  ///< greatest height since the ground was left, metres
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
/// motion is swept exactly (see `sweep`), whatever decided on it.
class CapsuleMover {
public:
    CapsuleMover(const World& world, const MoverSettings& settings, const QueryFilter& filter);

    /// Puts the body down at `foot`, which must be free (see free_place): on the ground if that is within
    /// `search` metres below, in the air otherwise.
    void place(MoverState& state, const Vec3& foot, double search, QueryCounters& counters);

    /// One tick: `wish` is the horizontal displacement asked for (y = 0), `seconds` the tick's length.
    void move(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace, QueryCounters& counters);

    /// Fills `trace.touching` for a body at rest.
    void touch(const MoverState& state, MoveTrace& trace, QueryCounters& counters);

private:
    enum class Kind : std::uint8_t { floor, step, wall };

    /// An obstacle as the body meets it at the start of a part of the move.
    struct Contact {
        const Obstacle* obstacle = nullptr;
        Closest closest;
        Vec3 normal = Vec3::Zero();  ///< from the obstacle to the body
        Kind kind = Kind::wall;
    };

    /// A wall as the horizontal solve sees it: the move may go at most `room` against `normal`.
    struct HalfPlane {
        double nx = 0.0;
        double nz = 0.0;
        double room = 0.0;
    };

    Segment body(const Vec3& foot) const;
    void gather(const Vec3& foot, double sideways, double up, double down, QueryCounters& counters);
    void find_contacts(const Vec3& foot, double reach);
    Kind kind_of(const Obstacle& obstacle, const Vec3& normal, const Vec3& foot) const;
    bool is_step(const Obstacle& obstacle, const Vec3& foot) const;
    bool owned_by_floor(const Vec3& point) const;

    void walk(MoverState& state, const Vec3& wish);
    void fall(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace);
    Vec3 slide(const Vec3& foot, const Vec3& wish);
    double needed_lift(const Vec3& foot, const Vec3& move) const;
    /// Sweeps the body and returns the displacement that is free.
    Vec3 free_part(const Vec3& foot, const Vec3& move, double radius) const;
    bool supported(const Vec3& foot) const;
    Vec3 resting_normal(const Vec3& foot) const;
    void list_touching(const Vec3& foot, MoveTrace& trace);

    static void land(MoverState& state, const Vec3& foot, MoveTrace& trace);

    static HalfPlane half_plane(const Contact& contact, double radius, double keep);
    static Vec3 solve(const Vec3& wish, const std::vector<HalfPlane>& planes);

    const World& world_;
    MoverSettings settings_;
    QueryFilter filter_;
    std::vector<Obstacle> obstacles_;
    std::vector<Contact> contacts_;
    std::vector<HalfPlane> planes_;
    std::vector<bool> in_solve_;
};

}  // namespace campuswalk::collision
