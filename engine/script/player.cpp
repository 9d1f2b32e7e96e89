#include "engine/script/player.h"

#include <algorithm>
#include <cmath>

#include "collision/geometry/trigonometry.h"
#include "engine/events/decimals.h"
#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

using collision::angle_of;
using collision::wrapped_angle;
using Eigen::Vector3d;

namespace {

/// Standing this far above or below a target that has a height still counts as being there, metres.
constexpr double kLevel = 0.5;
/// A walk_to or follow gives up after this many seconds in which its target came no nearer by kProgress, or
/// by half of what a slower avatar would walk in that time.
constexpr double kPatience = 1.5;
constexpr double kProgress = 0.05;  // metres
constexpr double kAligned = 1e-9;   // radians

double yaw_towards(const Vector3d& direction) {
    return angle_of(-direction.x(), -direction.z());
}

Vector3d flat(Vector3d v) {
    v.y() = 0.0;
    return v;
}

bool has_arrived(const Target& target, double within, const AvatarState& avatar) {
    const Vector3d way = target.point - avatar.position;
    return flat(way).norm() <= within && (!target.has_height || std::abs(way.y()) <= kLevel);
}

}  // namespace

// ---- what each kind of step does ------------------------------------------------------------------------

template <>
void ScriptPlayer::intend(const SpawnStep& step, const AvatarState&, Intent& intent) {
    intent.placement = {&step.label, step.position, EventKind::avatar_spawn};
    intent.yaw = wrapped_angle(step.yaw);
    intent.pitch = 0.0;
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const SpawnStep&, const AvatarState&) {
    return Outcome::done;
}

template <>
void ScriptPlayer::intend(const TeleportStep& step, const AvatarState& avatar, Intent& intent) {
    intent.placement = {&step.label, step.position, EventKind::avatar_teleport};
    intent.yaw = wrapped_angle(step.yaw.value_or(avatar.yaw));
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const TeleportStep&, const AvatarState&) {
    return Outcome::done;
}

template <>
void ScriptPlayer::intend(const WalkToStep& step, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(step.speed);
    if (progress_.ticks == 0) {
        const double distance = flat(step.target.point - avatar.position).norm();
        progress_.allowed = step.timeout.value_or(2.0 * distance / speed + 5.0);
    }
    go_towards(step.target.point, speed, avatar, intent);
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const WalkToStep& step, const AvatarState& avatar) {
    if (has_arrived(step.target, step.within, avatar)) {
        return Outcome::arrived;
    }
    const double distance = flat(step.target.point - avatar.position).norm();
    return gives_up(distance, speed_of(step.speed)) ? Outcome::blocked : Outcome::going;
}

template <>
void ScriptPlayer::intend(const FollowStep& step, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(step.speed);
    if (progress_.ticks == 0) {
        curve_.start(avatar.position, step.points);
        progress_.allowed = step.timeout.value_or(2.0 * curve_.length() / speed + 5.0);
    }
    go_towards(curve_.lead(avatar.position, speed * dt_), speed, avatar, intent);
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const FollowStep& step, const AvatarState& avatar) {
    if (curve_.at_end() && has_arrived(step.points.back(), step.within, avatar)) {
        return Outcome::arrived;
    }
    return gives_up(curve_.remaining(avatar.position), speed_of(step.speed)) ? Outcome::blocked
                                                                             : Outcome::going;
}

/// Someone in the air comes down first.
template <>
void ScriptPlayer::intend(const JumpStep& step, const AvatarState& avatar, Intent& intent) {
    if (!progress_.jumped && !avatar.grounded) {
        return;
    }
    if (!progress_.jumped) {
        intent.jump = step.speed;
        progress_.jumped = true;
    }
    const auto [sin, cos] = collision::sin_cos(avatar.yaw);
    intent.move = step.forward * dt_ * Vector3d(-sin, 0.0, -cos);
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const JumpStep&, const AvatarState& avatar) {
    return progress_.jumped && avatar.grounded ? Outcome::done : Outcome::going;
}

template <>
void ScriptPlayer::intend(const WaitStep&, const AvatarState&, Intent&) {}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const WaitStep& step, const AvatarState&) {
    return static_cast<double>(progress_.ticks) >= step.seconds * walk_.sim.ticks_per_second - 1e-9
               ? Outcome::done
               : Outcome::going;
}

template <>
void ScriptPlayer::intend(const WaitUntilStep&, const AvatarState&, Intent&) {}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const WaitUntilStep& step, const AvatarState&) {
    if (progress_.heard) {
        return Outcome::done;
    }
    const bool late =
        static_cast<double>(progress_.ticks) >= step.timeout * walk_.sim.ticks_per_second - 1e-9;
    return late ? Outcome::timed_out : Outcome::going;
}

/// To an angle the short way; by an angle all the way, however often around.
template <>
void ScriptPlayer::intend(const TurnStep& step, const AvatarState& avatar, Intent& intent) {
    const double rest =
        progress_.turn_left.value_or(step.absolute ? wrapped_angle(step.angle - avatar.yaw) : step.angle);
    const double most = walk_.avatar.turn_speed * dt_;
    const double part = std::clamp(rest, -most, most);
    intent.yaw = wrapped_angle(avatar.yaw + part);
    progress_.turn_left = rest - part;
    progress_.aligned = std::abs(rest - part) <= kAligned;
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const TurnStep&, const AvatarState&) {
    return progress_.aligned ? Outcome::done : Outcome::going;
}

template <>
void ScriptPlayer::intend(const LookAtStep& step, const AvatarState& avatar, Intent& intent) {
    const Vector3d eye = avatar.position + Vector3d(0, avatar.stature * walk_.avatar.eye_height, 0);
    const Vector3d way = step.target.point - eye;
    const double distance = flat(way).norm();
    const double yaw = distance > 0.0 ? yaw_towards(way) : avatar.yaw;
    const double pitch = step.target.has_height ? angle_of(way.y(), distance) : 0.0;
    intent.yaw = turned(avatar.yaw, yaw);
    intent.pitch = turned(avatar.pitch, pitch);
    progress_.aligned = std::abs(wrapped_angle(intent.yaw - yaw)) <= kAligned &&
                        std::abs(wrapped_angle(intent.pitch - pitch)) <= kAligned;
}

template <>
ScriptPlayer::Outcome ScriptPlayer::outcome(const LookAtStep&, const AvatarState&) {
    return progress_.aligned ? Outcome::done : Outcome::going;
}

// ---- the player ----------------------------------------------------------------------------------------

ScriptPlayer::ScriptPlayer(const Walk& walk) : walk_(walk), dt_(1.0 / walk.sim.ticks_per_second) {}

Intent ScriptPlayer::intend(const AvatarState& avatar) {
    Intent intent;
    intent.yaw = avatar.yaw;
    intent.pitch = avatar.pitch;
    if (!finished()) {
        std::visit([&](const auto& step) { intend(step, avatar, intent); }, walk_.steps[current_]);
        ++progress_.ticks;
    }
    return intent;
}

void ScriptPlayer::observe(std::span<const Event> events) {
    if (finished()) {
        return;
    }
    if (const auto* wait = std::get_if<WaitUntilStep>(&walk_.steps[current_])) {
        progress_.heard = progress_.heard || std::ranges::any_of(events, [&](const Event& event) {
                              return matches(wait->event, event);
                          });
    }
}

std::optional<StepEnd> ScriptPlayer::settle(const AvatarState& avatar, std::vector<const Step*>& instant) {
    if (finished()) {
        return std::nullopt;
    }
    const Step& step = walk_.steps[current_];
    const Outcome result = std::visit([&](const auto& s) { return outcome(s, avatar); }, step);
    if (result == Outcome::going) {
        return std::nullopt;
    }
    std::optional<StepEnd> end = end_of(step, result, avatar);
    progress_ = {};
    ++current_;
    if (end && end->fatal) {
        return end;
    }
    for (; !finished() && is_instant(walk_.steps[current_]); ++current_) {
        if (const auto* speed = std::get_if<SpeedStep>(&walk_.steps[current_])) {
            pace_ = speed->speed;
        } else {
            instant.push_back(&walk_.steps[current_]);
        }
    }
    return end;
}

const SourceMark* ScriptPlayer::mark() const {
    return finished() ? nullptr : &mark_of(walk_.steps[current_]);
}

std::optional<StepEnd> ScriptPlayer::end_of(const Step& step, Outcome result,
                                            const AvatarState& avatar) const {
    const auto end_of_way = [&](const auto& way, const Target& target, const char* verb) {
        if (result == Outcome::arrived) {
            return StepEnd{EventKind::avatar_arrive, &target.label, &way.mark, false, "", ""};
        }
        return StepEnd{
            EventKind::avatar_blocked,
            &target.label,
            &way.mark,
            way.if_blocked == IfBlocked::fail,
            "blocked",
            verb + (" " + target.label) + " was not reached" + why_not_reached(target, way.within, avatar)};
    };
    if (const auto* walk_to = std::get_if<WalkToStep>(&step)) {
        return end_of_way(*walk_to, walk_to->target, "walk_to");
    }
    if (const auto* follow = std::get_if<FollowStep>(&step)) {
        return end_of_way(*follow, follow->points.back(), "follow");
    }
    if (const auto* wait = std::get_if<WaitUntilStep>(&step); wait && result == Outcome::timed_out) {
        return StepEnd{std::nullopt,
                       nullptr,
                       &wait->mark,
                       true,
                       "timeout",
                       "'" + told(wait->event) + "' did not come within " + fixed(wait->timeout, 1) + " s"};
    }
    return std::nullopt;
}

double ScriptPlayer::speed_of(const std::optional<double>& own) const {
    return own.value_or(pace_.value_or(walk_.avatar.speed));
}

void ScriptPlayer::go_towards(const Vector3d& point, double speed, const AvatarState& avatar,
                              Intent& intent) {
    const Vector3d way = flat(point - avatar.position);
    if (const double distance = way.norm(); distance > 0.0) {
        intent.move = way * (std::min(distance, speed * dt_) / distance);
        intent.yaw = turned(avatar.yaw, yaw_towards(way));
    }
    intent.pitch = turned(avatar.pitch, 0.0);
}

bool ScriptPlayer::gives_up(double remaining, double speed) {
    if (remaining < progress_.nearest - std::min(kProgress, 0.5 * speed * kPatience)) {
        progress_.nearest = remaining;
        progress_.since_closer = progress_.ticks;
    }
    const double idle = static_cast<double>(progress_.ticks - progress_.since_closer) * dt_;
    return static_cast<double>(progress_.ticks) * dt_ >= progress_.allowed || idle >= kPatience;
}

std::string ScriptPlayer::why_not_reached(const Target& target, double within,
                                          const AvatarState& avatar) const {
    const Vector3d way = target.point - avatar.position;
    if (flat(way).norm() <= within) {
        return ": it is " + fixed(std::abs(way.y()), 3) + " m " + (way.y() > 0.0 ? "above" : "below") +
               " the avatar's feet";
    }
    const bool late = static_cast<double>(progress_.ticks) * dt_ >= progress_.allowed;
    return late ? " within " + fixed(progress_.allowed, 1) + " s, still " + fixed(flat(way).norm(), 3) +
                      " m away"
                : "";
}

/// `from` turned towards `to` the short way, by no more than a tick's worth.
double ScriptPlayer::turned(double from, double to) const {
    const double most = walk_.avatar.turn_speed * dt_;
    const double difference = wrapped_angle(to - from);
    return std::abs(difference) <= most ? wrapped_angle(to)
                                        : wrapped_angle(from + std::clamp(difference, -most, most));
}

}  // namespace campuswalk::engine
