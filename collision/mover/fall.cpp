#include "collision/mover/fall.h"

#include <algorithm>
#include <cmath>
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
/// A body that gets less than this share of its fall down is wedged: it stands.
constexpr double kWedged = 0.01;

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

/// The steepest normal of what the body rests on.
Vec3 resting_normal(MoveContext& context, const Vec3& foot) {
    Vec3 steepest = Vec3::UnitY();
    const auto key = [](const Vec3& n) { return std::tuple(n.y(), n.x(), n.z()); };
    for (const ContactCache::Index i : context.near) {
        const Separation& s = context.contacts.measure(i, foot);
        const bool touches = s.distance > 0.0 && s.distance <= context.body.radius + 2.0 * kRestGap;
        if (touches && s.normal.y() > 0.0 && key(s.normal) < key(steepest)) {
            steepest = s.normal;
        }
    }
    return steepest;
}

/// Down along what it rests on; where something else is soon in the way, down along that as well, and so on:
/// between two edges that hardly overlap it, a body would hang for ever that left only the first of them.
Vec3 fall_along_contacts(MoveContext& context, MoverState& state, const Vec3& start, Vec3 foot, double rest,
                         double seconds) {
    for (int contacts = 0; contacts < kMostContacts; ++contacts) {
        const Vec3 n = resting_normal(context, foot);
        if (contacts > 0 && n == Vec3::UnitY()) {
            break;  // nothing holds it any more
        }
        const double freely = rest * (1.0 - n.y() * n.y());
        const double before = foot.y();
        foot = fall_along(context, foot, n, rest);
        turn_along(context.body, state, n, (foot - start).norm(), seconds);
        rest -= foot.y() - before;
        const bool is_blocked = foot.y() - before > 0.5 * freely;
        if (!is_blocked || rest > -kStill) {
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

}  // namespace

Ground underfoot(MoveContext& context, const Vec3& foot, double min_drop) {
    return find_ground(context, foot.x(), foot.z(), {foot, foot.y()}, 4.0 * kRestGap, 4.0 * kRestGap,
                       min_drop);
}

void fall(MoveContext& context, MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
    const Vec3 start = state.foot;
    const double rise = state.vertical_speed * seconds - 0.5 * context.body.gravity * seconds * seconds;
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
    state.vertical_speed -= context.body.gravity * seconds;
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
        const bool wedged = start.y() - foot.y() < -kWedged * rise;
        const Ground ground = underfoot(context, foot, wedged ? kMinSupportDrop : kMinLandingDrop);
        if (wedged || ground.carries) {
            land(state, foot, ground, trace);
            return;
        }
    }
    state.foot = foot;
}

}  // namespace campuswalk::collision
