#include "collision/mover/fall.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "collision/mover/motion_clearance.h"
#include "collision/mover/wall_slide.h"

namespace campuswalk::collision {

namespace {

/// A body that moves less than this doesn't move, metres.
constexpr double kStill = 1e-9;
/// Of what is in the way of a fall, so much is passed in a tick, one after the other.
constexpr int kMostContacts = 4;
/// A body that gets less than this share of its fall down is stuck in that tick.
constexpr double kStuck = 0.01;
/// Then it falls no faster than gravity made it in one tick, but for this factor.
constexpr double kFromRest = 1.1;
/// What is nearer to a stuck body holds it, metres: where it has a little play, not all of it touches.
constexpr double kHolds = 5e-4;
/// The horizontal part of the normal of what may hold a body at its sides, and of what is a wall.
constexpr double kSide = 0.01;
constexpr double kWall = 0.99;
/// A way aside leads away from all that holds the body by at least this cosine.
constexpr double kLeadsAway = 0.05;

/// Walls stop the slide, as they stop the desired displacement.
void limit_slide(MoverState& state, double seconds, std::span<const HalfPlane> walls) {
    const Vec3 own = seconds * state.slide_velocity;
    if (const Vec3 left = nearest_allowed(own, walls); left != own) {
        state.slide_velocity = left / seconds;
    }
}

/// On what is too steep to stand on, the velocity turns down the slope without friction: it loses the
/// component into the slope. A body that is also supported elsewhere must not build up speed that it can't
/// turn into motion.
void turn_along(const MoverSettings& body, MoverState& state, const Vec3& n, double moved, double seconds) {
    Vec3 velocity = state.slide_velocity + Vec3(0, state.vertical_speed, 0);
    velocity -= std::min(0.0, velocity.dot(n)) * n;
    const double most = moved / seconds + body.gravity * seconds;
    if (const double speed = velocity.norm(); speed > most) {
        velocity *= most / speed;
    }
    state.slide_velocity = Vec3(velocity.x(), 0, velocity.z());
    state.vertical_speed = velocity.y();
}

/// On what is too steep to stand on, the rest of the fall continues down the slope.
Vec3 fall_along(MoveContext& context, const Vec3& foot, const Vec3& n, double rest) {
    const Vec3 along = rest * (Vec3::UnitY() - n.y() * n);
    const Vec3 flat = slide(context, {foot, foot.y()}, Vec3(along.x(), 0, along.z()), false).move;
    const Vec3 across = foot + free_part(context, foot, flat, context.body.radius + kSweepGap);
    return across + free_part(context, across, Vec3(0, along.y(), 0), context.body.radius + kRestGap);
}

/// The horizontal direction that leads away from all that is nearer to the body, and is at least so steep
/// (the horizontal part of its normal); of several the one that does so most. None if each leads to
/// something.
std::optional<Vec3> direction_away(MoveContext& context, const Vec3& foot, double nearer, double steepness) {
    std::vector<Vec3>& normals = context.buffers.sides;
    normals.clear();
    for (const ContactCache::Index i : context.near) {
        const Separation& s = context.contacts.measure(i, foot);
        const double aside = horizontal_norm(s.normal);
        if (s.distance < nearer && aside >= steepness) {
            normals.push_back(Vec3(s.normal.x(), 0, s.normal.z()) / aside);
        }
    }
    std::optional<Vec3> best;
    double most = kLeadsAway;
    // It leads away from one of them, or as much from one as from another.
    for (std::size_t i = 0; i < normals.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            const Vec3 sum = normals[i] + normals[k];
            const double length = sum.norm();
            double least = 1.0;
            for (const Vec3& n : normals) {
                least = std::min(least, n.dot(sum) / std::max(length, kStill));
            }
            if (least > most) {
                most = least;
                best = sum / length;
            }
        }
    }
    return best;
}

/// Away from walls that are no farther than kRestGap, as other motions may leave them: a fall would end
/// there.
Vec3 leave_rest_gap(MoveContext& context, const Vec3& foot) {
    const double clear = context.body.radius + kRestGap;
    const auto aside = direction_away(context, foot, clear + kStill, kWall);
    if (!aside) {
        return foot;
    }
    double needed = 0.0;
    for (const ContactCache::Index i : context.near) {
        const Separation& s = context.contacts.measure(i, foot);
        const double away = s.normal.dot(*aside);
        if (s.distance < clear + kStill && away > 0.0) {
            needed = std::max(needed, (clear + 2.0 * kStill - s.distance) / away);
        }
    }
    return foot + free_part(context, foot, needed * *aside, context.body.radius + kSweepGap);
}

/// The steepest normal of what the body rests on, of those that are less steep than `than`.
Vec3 resting_normal(MoveContext& context, const Vec3& foot, const Vec3& than) {
    Vec3 steepest = Vec3::UnitY();
    const auto key = [](const Vec3& n) { return std::tuple(n.y(), n.x(), n.z()); };
    for (const ContactCache::Index i : context.near) {
        const Separation& s = context.contacts.measure(i, foot);
        const bool touches = s.distance > 0.0 && s.distance <= context.body.radius + 2.0 * kRestGap;
        if (touches && s.normal.y() > 0.0 && key(than) < key(s.normal) && key(s.normal) < key(steepest)) {
            steepest = s.normal;
        }
    }
    return steepest;
}

/// Down along what it rests on; where something else is soon in the way, down along that as well, and so on:
/// between two edges that hardly overlap it, a body would hang for ever that left only the first of them.
/// No farther aside than was surveyed, and not past what carries it.
Vec3 fall_along_contacts(MoveContext& context, MoverState& state, const Vec3& start, Vec3 foot, double rest,
                         double seconds) {
    const Vec3 first = foot;
    const double farthest = -0.5 * rest;
    Vec3 steeper = Vec3::Zero();  // what didn't lead on
    for (int contacts = 0; contacts < kMostContacts; ++contacts) {
        foot = leave_rest_gap(context, foot);
        const Vec3 n = resting_normal(context, foot, steeper);
        if (n == Vec3::UnitY()) {  // nothing holds it any more
            foot += free_part(context, foot, Vec3(0, rest, 0), context.body.radius + kRestGap);
            break;
        }
        const double freely = rest * (1.0 - n.y() * n.y());
        const double before = foot.y();
        foot = fall_along(context, foot, n, rest);
        turn_along(context.body, state, n, (foot - start).norm(), seconds);
        rest -= foot.y() - before;
        steeper = foot.y() - before > kStuck * rest ? n : Vec3(Vec3::Zero());
        const bool is_blocked = foot.y() - before > 0.5 * freely;
        if (!is_blocked || rest > -kStill || horizontal_norm(foot - first) > farthest ||
            underfoot(context, foot, kMinLandingDrop).carries) {
            break;
        }
    }
    return foot;
}

void land(MoverState& state, const Vec3& foot, const Ground& ground, MoveTrace& trace) {
    trace.landed = true;
    trace.fall_height = std::max(trace.fall_height, state.fall_from - foot.y());
    state.foot = foot;
    state.grounded = true;
    state.support_y = ground.support_y;
    state.vertical_speed = 0.0;
    state.slide_velocity = Vec3::Zero();
}

/// Whether nothing leads a stuck body away from what holds it. Only where it was stuck in the tick before as
/// well, what is within its skin counts too: it comes no nearer to that, but may sink slowly between.
bool is_wedged(MoveContext& context, const Vec3& foot, bool was_stuck) {
    const double nearer = was_stuck ? context.body.skin + 2.0 * kRestGap : kHolds;
    return !direction_away(context, foot, context.body.radius + nearer, kSide);
}

}  // namespace

Ground underfoot(MoveContext& context, const Vec3& foot, double min_drop) {
    return find_ground(context, foot.x(), foot.z(), {foot, foot.y()}, 4.0 * kRestGap, 4.0 * kRestGap,
                       min_drop);
}

void fall(MoveContext& context, MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
    const MoverState before = state;
    const Vec3& start = before.foot;
    const double gained = context.body.gravity * seconds;
    const double rise = before.vertical_speed * seconds - 0.5 * gained * seconds;
    Vec3 foot = start;
    Vec3 vertical = Vec3::Zero();
    if (rise > 0.0) {
        vertical = free_part(context, foot, Vec3(0, rise, 0), context.body.radius + kSweepGap);
        foot += vertical;
    }
    const Slide across = slide(context, {foot, foot.y()}, desired + seconds * state.slide_velocity, false);
    foot += free_part(context, foot, across.move, context.body.radius + kSweepGap);
    limit_slide(state, seconds, across.walls);
    if (rise <= 0.0) {
        vertical = free_part(context, foot, Vec3(0, rise, 0), context.body.radius + kRestGap);
        foot += vertical;
    }
    state.vertical_speed -= gained;
    state.fall_from = std::max(state.fall_from, foot.y());
    const double rest = rise - vertical.y();
    if (rest > 0.0) {
        state.vertical_speed = 0.0;
    } else if (rest < 0.0) {
        if (const Ground ground = underfoot(context, foot, kMinLandingDrop); ground.carries) {
            land(state, foot, ground, trace);
            return;
        }
        foot = fall_along_contacts(context, state, start, foot, rest, seconds);
        const bool is_stuck = before.vertical_speed <= 0.0 && start.y() - foot.y() < -kStuck * rise;
        const bool was_stuck = -before.vertical_speed <= kFromRest * gained;
        const bool wedged = is_stuck && is_wedged(context, foot, was_stuck);
        const Ground ground = underfoot(context, foot, wedged ? kMinSupportDrop : kMinLandingDrop);
        if (wedged || ground.carries) {
            land(state, foot, ground, trace);
            return;
        }
        if (is_stuck && was_stuck && !desired.isZero()) {  // pushing alone holds it: it falls on all the same
            state = before;
            fall(context, state, Vec3::Zero(), seconds, trace);
            return;
        }
    }
    state.foot = foot;
}

}  // namespace campuswalk::collision
