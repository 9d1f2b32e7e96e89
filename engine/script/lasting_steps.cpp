#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "collision/geometry/trigonometry.h"
#include "collision/mover/mover_settings.h"
#include "engine/events/decimals.h"
#include "engine/script/event_pattern.h"
#include "engine/script/expectation.h"
#include "engine/script/player.h"
#include "engine/script/travel.h"

// What the avatar does in each kind of step that takes time: before a tick (`intend`), after it (`end_of`)
// and, when a walk's time is estimated, as a whole (`Plan::add`).

namespace campuswalk::engine {

using collision::angle_of;
using collision::wrapped_angle;
using Eigen::Vector3d;

namespace {

constexpr double kAligned = 1e-9;  // radians

double yaw_towards(const Vector3d& direction) {
    return angle_of(-direction.x(), -direction.z());
}

/// The end of a step that reports nothing.
std::optional<StepEnd> over_if(bool over) {
    return over ? std::optional(StepEnd()) : std::nullopt;
}

/// When the steps so far are over if nothing is in the way, and where the avatar is then.
class Plan {
public:
    explicit Plan(const AvatarProfile& avatar) : avatar_(avatar), speed_(avatar.speed) {}

    double seconds() const { return seconds_; }

    void add(const SpawnStep& step) { put(step.position, step.yaw); }
    void add(const TeleportStep& step) { put(step.position, step.yaw.value_or(yaw_)); }
    void add(const WalkToStep& step) {
        const double distance = flat(step.target.point - position_).norm();
        travel(step, std::max(0.0, distance - step.within));
        arrive(position_, step.target.point);
    }
    /// As if the way through its points were straight.
    void add(const GoToStep& step) {
        std::vector<Target> points = step.through;
        points.push_back(step.target);
        double length = 0.0;
        for (const Target& point : points) {
            length += flat(point.point - position_).norm();
            arrive(position_, point.point);
        }
        travel(step, length);
    }
    void add(const FollowStep& step) {
        CurveWalk curve;
        curve.start(position_, step.points);
        travel(step, std::max(0.0, curve.length() - step.within));
        const std::size_t count = step.points.size();
        arrive(count > 1 ? step.points[count - 2].point : position_, step.points.back().point);
    }
    void add(const WaitStep& step) { seconds_ += step.seconds; }
    void add(const WaitUntilStep&) { seconds_ = std::numeric_limits<double>::infinity(); }
    void add(const TurnStep& step) { turn(step.absolute ? wrapped_angle(step.angle - yaw_) : step.angle); }
    void add(const LookAtStep& step) { turn(wrapped_angle(yaw_from(position_, step.target.point) - yaw_)); }
    void add(const JumpStep& step) { seconds_ += 2.0 * step.speed / collision::MoverSettings().gravity; }
    void add(const SpeedStep& step) { speed_ = step.speed; }
    template <InstantStep Instant>
    void add(const Instant&) {}

private:
    /// No longer than the step may.
    template <typename Travel>
    void travel(const Travel& step, double length) {
        const double seconds = length / step.speed.value_or(speed_);
        seconds_ += std::min(seconds, step.timeout.value_or(seconds));
    }
    void put(const Vector3d& position, double yaw) {
        position_ = position;
        yaw_ = yaw;
    }
    void arrive(const Vector3d& from, const Vector3d& to) { put(to, yaw_from(from, to)); }
    double yaw_from(const Vector3d& from, const Vector3d& to) const {
        const Vector3d direction = flat(to - from);
        return direction.isZero(0.0) ? yaw_ : yaw_towards(direction);
    }
    void turn(double angle) {
        seconds_ += std::abs(angle) / avatar_.turn_speed;
        yaw_ += angle;
    }

    const AvatarProfile& avatar_;
    double speed_;
    Vector3d position_ = Vector3d::Zero();
    double yaw_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace

// ---- spawn and teleport ---------------------------------------------------------------------------------

template <>
void ScriptPlayer::intend(const SpawnStep& step, const AvatarState&, Intent& intent) {
    intent.placement = {&step.label, step.position, EventKind::avatar_spawn};
    intent.yaw = wrapped_angle(step.yaw);
    intent.pitch = 0.0;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const SpawnStep&, const AvatarState&) {
    return over_if(true);
}

template <>
void ScriptPlayer::intend(const TeleportStep& step, const AvatarState& avatar, Intent& intent) {
    intent.placement = {&step.label, step.position, EventKind::avatar_teleport};
    intent.yaw = wrapped_angle(step.yaw.value_or(avatar.yaw));
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const TeleportStep&, const AvatarState&) {
    return over_if(true);
}

// ---- walk_to and follow ---------------------------------------------------------------------------------

template <>
void ScriptPlayer::intend(const WalkToStep& step, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(step.speed);
    if (progress_.ticks == 0) {
        const double distance = flat(step.target.point - avatar.position).norm();
        progress_.allowed = step.timeout.value_or(default_timeout(distance, speed));
    }
    go_towards(step.target.point, speed, avatar, intent);
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const WalkToStep& step, const AvatarState& avatar) {
    if (has_arrived(step.target, step.within, avatar.position, avatar.grounded)) {
        return StepEnd{EventKind::avatar_arrive, &step.target.label, &step.mark};
    }
    const double remaining = flat(step.target.point - avatar.position).norm();
    return gives_up(remaining, avatar.grounded, speed_of(step.speed))
               ? blocked("walk_to", step, step.target, avatar)
               : std::nullopt;
}

template <>
void ScriptPlayer::intend(const FollowStep& step, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(step.speed);
    if (progress_.ticks == 0) {
        curve_.start(avatar.position, step.points);
        progress_.allowed = step.timeout.value_or(default_timeout(curve_.length(), speed));
    }
    go_towards(curve_.lead(avatar.position, speed * dt_), speed, avatar, intent);
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const FollowStep& step, const AvatarState& avatar) {
    const Target& last = step.points.back();
    if (curve_.at_end() && has_arrived(last, step.within, avatar.position, avatar.grounded)) {
        return StepEnd{EventKind::avatar_arrive, &last.label, &step.mark};
    }
    return gives_up(curve_.remaining(avatar.position), avatar.grounded, speed_of(step.speed))
               ? blocked("follow", step, last, avatar)
               : std::nullopt;
}

// ---- go_to ----------------------------------------------------------------------------------------------

/// The route's pieces, one after another, just as they were walked when it was planned.
template <>
void ScriptPlayer::intend(const GoToStep& step, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(step.speed);
    if (progress_.ticks == 0) {
        assert(routes_ != nullptr);
        route_ = routes_->plan(step, speed);
        piece_ = 0;
        piece_ticks_ = 0;
        const double seconds = static_cast<double>(route_.route.ticks()) * dt_;
        progress_.allowed = step.timeout.value_or(default_timeout(speed * seconds, speed));
    }
    if (route_.why_not) {
        return;
    }
    const RoutePiece& piece = route_.route.pieces[piece_];
    if (!piece.stride) {
        go_towards(piece.target.point, speed, avatar, intent);
    } else if (!piece.stride->isZero(0.0)) {
        intent.move = *piece.stride;
        intent.yaw = turned(avatar.yaw, yaw_towards(*piece.stride));
    }
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const GoToStep& step, const AvatarState& avatar) {
    const auto fatal = [&](std::string_view code, const std::string& why) {
        return StepEnd{std::nullopt, nullptr, &step.mark,        nullptr,
                       0.0,          true,    std::string(code), "go_to " + step.target.label + why};
    };
    if (route_.why_not) {
        StepEnd end = is_unsearched(*route_.why_not)
                          ? fatal(kRouteUnknown, ": it isn't known whether a route leads there")
                          : fatal("unreachable", " can't be reached");
        end.reason = route_.why_not;
        return end;
    }
    const RoutePiece& piece = route_.route.pieces[piece_];
    ++piece_ticks_;
    if (piece.stride ? piece_ticks_ == piece.ticks
                     : has_arrived(piece.target, piece.within, avatar.position, avatar.grounded)) {
        ++piece_;
        piece_ticks_ = 0;
    }
    if (piece_ == route_.route.pieces.size()) {
        return StepEnd{EventKind::avatar_arrive, &step.target.label, &step.mark};
    }
    return progress_.is_late(dt_) ? std::optional(fatal("timeout", " was not reached within " +
                                                                       fixed(progress_.allowed, 1) + " s"))
                                  : std::nullopt;
}

// ---- jump -----------------------------------------------------------------------------------------------

/// An avatar in the air lands first.
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
std::optional<StepEnd> ScriptPlayer::end_of(const JumpStep&, const AvatarState& avatar) {
    return over_if(progress_.jumped && avatar.grounded);
}

// ---- wait and wait_until --------------------------------------------------------------------------------

template <>
void ScriptPlayer::intend(const WaitStep&, const AvatarState&, Intent&) {}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const WaitStep& step, const AvatarState&) {
    return over_if(walk_.sim.has_passed(step.seconds, progress_.ticks));
}

template <>
void ScriptPlayer::intend(const WaitUntilStep&, const AvatarState&, Intent&) {}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const WaitUntilStep& step, const AvatarState&) {
    if (progress_.awaited_event_came) {
        return StepEnd();
    }
    if (!walk_.sim.has_passed(step.timeout, progress_.ticks)) {
        return std::nullopt;
    }
    const std::string message =
        "'" + to_string(step.event) + "' did not occur within " + fixed(step.timeout, 1) + " s";
    return StepEnd{std::nullopt, nullptr, &step.mark, nullptr, 0.0, true, "timeout", message};
}

// ---- turn and look_at -----------------------------------------------------------------------------------

/// To an angle the short way; by an angle all of it, even several times around.
template <>
void ScriptPlayer::intend(const TurnStep& step, const AvatarState& avatar, Intent& intent) {
    const double remaining = progress_.turn_remaining.value_or(
        step.absolute ? wrapped_angle(step.angle - avatar.yaw) : step.angle);
    const double max_turn = walk_.avatar.turn_speed * dt_;
    const double part = std::clamp(remaining, -max_turn, max_turn);
    intent.yaw = wrapped_angle(avatar.yaw + part);
    progress_.turn_remaining = remaining - part;
    progress_.aligned = std::abs(remaining - part) <= kAligned;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const TurnStep&, const AvatarState&) {
    return over_if(progress_.aligned);
}

template <>
void ScriptPlayer::intend(const LookAtStep& step, const AvatarState& avatar, Intent& intent) {
    const Vector3d eye = avatar.position + Vector3d(0, avatar.stature * walk_.avatar.eye_height, 0);
    const Vector3d direction = step.target.point - eye;
    const double distance = flat(direction).norm();
    const double yaw = distance > 0.0 ? yaw_towards(direction) : avatar.yaw;
    const double pitch = step.target.has_height ? angle_of(direction.y(), distance) : 0.0;
    intent.yaw = turned(avatar.yaw, yaw);
    intent.pitch = turned(avatar.pitch, pitch);
    progress_.aligned = std::abs(wrapped_angle(intent.yaw - yaw)) <= kAligned &&
                        std::abs(wrapped_angle(intent.pitch - pitch)) <= kAligned;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(const LookAtStep&, const AvatarState&) {
    return over_if(progress_.aligned);
}

// ---- all of them ----------------------------------------------------------------------------------------

void ScriptPlayer::intend_step(const AvatarState& avatar, Intent& intent) {
    std::visit([&](const auto& step) { intend(step, avatar, intent); }, walk_.steps[current_]);
}

std::optional<StepEnd> ScriptPlayer::end_of_step(const AvatarState& avatar) {
    return std::visit([&](const auto& step) { return end_of(step, avatar); }, walk_.steps[current_]);
}

std::optional<double> planned_seconds(const Walk& walk) {
    Plan plan(walk.avatar);
    for (const Step& step : walk.steps) {
        std::visit([&plan](const auto& each) { plan.add(each); }, step);
    }
    return std::isfinite(plan.seconds()) ? std::optional(plan.seconds()) : std::nullopt;
}

// ---- what several of them do ----------------------------------------------------------------------------

double ScriptPlayer::speed_of(const std::optional<double>& own) const {
    return own.value_or(speed_.value_or(walk_.avatar.speed));
}

void ScriptPlayer::go_towards(const Vector3d& point, double speed, const AvatarState& avatar,
                              Intent& intent) {
    intent.move = displacement_towards(point, avatar.position, speed * dt_);
    if (const Vector3d direction = flat(point - avatar.position); direction.norm() > 0.0) {
        intent.yaw = turned(avatar.yaw, yaw_towards(direction));
    }
    intent.pitch = turned(avatar.pitch, 0.0);
}

bool ScriptPlayer::gives_up(double remaining, bool grounded, double speed) {
    return progress_.gives_up(remaining, grounded, speed, dt_);
}

template <typename Travel>
std::optional<StepEnd> ScriptPlayer::blocked(const char* verb, const Travel& step, const Target& target,
                                             const AvatarState& avatar) const {
    return StepEnd{
        EventKind::avatar_blocked,
        &target.label,
        &step.mark,
        &target,
        step.within,
        step.if_blocked == IfBlocked::fail,
        "blocked",
        verb + (" " + target.label) + " was not reached" + why_not_reached(target, step.within, avatar)};
}

std::string ScriptPlayer::why_not_reached(const Target& target, double within,
                                          const AvatarState& avatar) const {
    const Vector3d to_target = target.point - avatar.position;
    if (flat(to_target).norm() <= within) {
        return ": it is " + fixed(std::abs(to_target.y()), 3) + " m " +
               (to_target.y() > 0.0 ? "above" : "below") + " the avatar's feet";
    }
    const bool late = progress_.is_late(dt_);
    return late ? " within " + fixed(progress_.allowed, 1) + " s, still " + fixed(flat(to_target).norm(), 3) +
                      " m away"
                : "";
}

double ScriptPlayer::turned(double from, double to) const {
    const double max_turn = walk_.avatar.turn_speed * dt_;
    const double difference = wrapped_angle(to - from);
    return std::abs(difference) <= max_turn
               ? wrapped_angle(to)
               : wrapped_angle(from + std::clamp(difference, -max_turn, max_turn));
}

}  // namespace campuswalk::engine
