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
#include "engine/script/failure_codes.h"
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

std::optional<StepEnd> over_if(bool over) {
    return over ? std::optional(StepEnd::unlogged()) : std::nullopt;
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
void ScriptPlayer::intend(Playing<SpawnStep>& playing, const AvatarState&, Intent& intent) {
    intent.placement = {&playing.step.label, playing.step.position, EventKind::avatar_spawn};
    intent.yaw = wrapped_angle(playing.step.yaw);
    intent.pitch = 0.0;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<SpawnStep>&, const AvatarState&) {
    return over_if(true);
}

template <>
void ScriptPlayer::intend(Playing<TeleportStep>& playing, const AvatarState& avatar, Intent& intent) {
    intent.placement = {&playing.step.label, playing.step.position, EventKind::avatar_teleport};
    intent.yaw = wrapped_angle(playing.step.yaw.value_or(avatar.yaw));
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<TeleportStep>&, const AvatarState&) {
    return over_if(true);
}

// ---- walk_to and follow ---------------------------------------------------------------------------------

template <>
void ScriptPlayer::intend(Playing<WalkToStep>& playing, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(playing.step.speed);
    if (playing.progress.ticks++ == 0) {
        const double distance = flat(playing.step.target.point - avatar.position).norm();
        playing.progress.allowed = playing.step.timeout.value_or(default_timeout(distance, speed));
    }
    go_towards(playing.step.target.point, speed, avatar, intent);
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<WalkToStep>& playing, const AvatarState& avatar) {
    if (has_arrived(playing.step.target, playing.step.within, avatar.position, avatar.grounded)) {
        return StepEnd::arrived(playing.step.mark, playing.step.target);
    }
    const double remaining = flat(playing.step.target.point - avatar.position).norm();
    return end_if_blocked("walk_to", playing.step, playing.step.target, remaining, playing.progress, avatar);
}

template <>
void ScriptPlayer::intend(Playing<FollowStep>& playing, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(playing.step.speed);
    if (playing.progress.ticks++ == 0) {
        playing.curve.start(avatar.position, playing.step.points);
        playing.progress.allowed =
            playing.step.timeout.value_or(default_timeout(playing.curve.length(), speed));
    }
    go_towards(playing.curve.lead(avatar.position, speed * dt_), speed, avatar, intent);
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<FollowStep>& playing, const AvatarState& avatar) {
    const Target& last = playing.step.points.back();
    if (playing.curve.at_end() && has_arrived(last, playing.step.within, avatar.position, avatar.grounded)) {
        return StepEnd::arrived(playing.step.mark, last);
    }
    const double remaining = playing.curve.remaining(avatar.position);
    return end_if_blocked("follow", playing.step, last, remaining, playing.progress, avatar);
}

// ---- go_to ----------------------------------------------------------------------------------------------

/// The route's pieces, one after another, just as they were walked when it was planned.
template <>
void ScriptPlayer::intend(Playing<GoToStep>& playing, const AvatarState& avatar, Intent& intent) {
    const double speed = speed_of(playing.step.speed);
    if (playing.progress.ticks++ == 0) {
        assert(routes_ != nullptr);
        playing.planned = routes_->plan(playing.step, speed);
        const double seconds = static_cast<double>(playing.planned.route.ticks()) * dt_;
        playing.progress.allowed = playing.step.timeout.value_or(default_timeout(speed * seconds, speed));
    }
    if (playing.planned.why_not) {
        return;
    }
    const RoutePiece& piece = playing.planned.route.pieces[playing.piece];
    if (!piece.stride) {
        go_towards(piece.target.point, speed, avatar, intent);
    } else if (!piece.stride->isZero(0.0)) {
        intent.move = *piece.stride;
        intent.yaw = turned(avatar.yaw, yaw_towards(*piece.stride));
    }
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<GoToStep>& playing, const AvatarState& avatar) {
    const auto failed = [&](std::string_view code, const std::string& why) {
        return StepEnd::failed(playing.step.mark, code, "go_to " + playing.step.target.label + why,
                               playing.planned.why_not);
    };
    if (playing.planned.why_not) {
        return is_unsearched(*playing.planned.why_not)
                   ? failed(kRouteUnknown, ": it isn't known whether a route leads there")
                   : failed(kUnreachableCode, " can't be reached");
    }
    const std::vector<RoutePiece>& pieces = playing.planned.route.pieces;
    const RoutePiece& piece = pieces[playing.piece];
    ++playing.piece_ticks;
    if (piece.stride ? playing.piece_ticks == piece.ticks
                     : has_arrived(piece.target, piece.within, avatar.position, avatar.grounded)) {
        ++playing.piece;
        playing.piece_ticks = 0;
    }
    if (playing.piece == pieces.size()) {
        return StepEnd::arrived(playing.step.mark, playing.step.target);
    }
    if (!playing.progress.is_late(dt_)) {
        return std::nullopt;
    }
    return failed(kTimeoutCode, " was not reached within " + fixed(playing.progress.allowed, 1) + " s");
}

// ---- jump -----------------------------------------------------------------------------------------------

/// An avatar in the air lands first.
template <>
void ScriptPlayer::intend(Playing<JumpStep>& playing, const AvatarState& avatar, Intent& intent) {
    if (!playing.jumped && !avatar.grounded) {
        return;
    }
    if (!playing.jumped) {
        intent.jump = playing.step.speed;
        playing.jumped = true;
    }
    const auto [sin, cos] = collision::sin_cos(avatar.yaw);
    intent.move = playing.step.forward * dt_ * Vector3d(-sin, 0.0, -cos);
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<JumpStep>& playing, const AvatarState& avatar) {
    return over_if(playing.jumped && avatar.grounded);
}

// ---- wait and wait_until --------------------------------------------------------------------------------

template <>
void ScriptPlayer::intend(Playing<WaitStep>& playing, const AvatarState&, Intent&) {
    ++playing.ticks;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<WaitStep>& playing, const AvatarState&) {
    return over_if(walk_.sim.has_passed(playing.step.seconds, playing.ticks));
}

template <>
void ScriptPlayer::intend(Playing<WaitUntilStep>& playing, const AvatarState&, Intent&) {
    ++playing.ticks;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<WaitUntilStep>& playing, const AvatarState&) {
    if (playing.event_came) {
        return StepEnd::unlogged();
    }
    if (!walk_.sim.has_passed(playing.step.timeout, playing.ticks)) {
        return std::nullopt;
    }
    return StepEnd::failed(playing.step.mark, kTimeoutCode,
                           "'" + to_string(playing.step.event) + "' did not occur within " +
                               fixed(playing.step.timeout, 1) + " s");
}

// ---- turn and look_at -----------------------------------------------------------------------------------

/// To an angle the short way; by an angle all of it, even several times around.
template <>
void ScriptPlayer::intend(Playing<TurnStep>& playing, const AvatarState& avatar, Intent& intent) {
    const double remaining = playing.remaining.value_or(
        playing.step.absolute ? wrapped_angle(playing.step.angle - avatar.yaw) : playing.step.angle);
    const double max_turn = walk_.avatar.turn_speed * dt_;
    const double part = std::clamp(remaining, -max_turn, max_turn);
    intent.yaw = wrapped_angle(avatar.yaw + part);
    playing.remaining = remaining - part;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<TurnStep>& playing, const AvatarState&) {
    return over_if(std::abs(*playing.remaining) <= kAligned);
}

template <>
void ScriptPlayer::intend(Playing<LookAtStep>& playing, const AvatarState& avatar, Intent& intent) {
    const Vector3d eye = avatar.position + Vector3d(0, avatar.stature * walk_.avatar.eye_height, 0);
    const Vector3d direction = playing.step.target.point - eye;
    const double distance = flat(direction).norm();
    const double yaw = distance > 0.0 ? yaw_towards(direction) : avatar.yaw;
    const double pitch = playing.step.target.has_height ? angle_of(direction.y(), distance) : 0.0;
    intent.yaw = turned(avatar.yaw, yaw);
    intent.pitch = turned(avatar.pitch, pitch);
    playing.aligned = std::abs(wrapped_angle(intent.yaw - yaw)) <= kAligned &&
                      std::abs(wrapped_angle(intent.pitch - pitch)) <= kAligned;
}

template <>
std::optional<StepEnd> ScriptPlayer::end_of(Playing<LookAtStep>& playing, const AvatarState&) {
    return over_if(playing.aligned);
}

// ---- all of them ----------------------------------------------------------------------------------------

void ScriptPlayer::begin_step() {
    if (!finished()) {
        std::visit([&]<typename Kind>(const Kind& step) { playing_.emplace(Playing<Kind>{step}); },
                   walk_.steps[current_]);
    }
}

void ScriptPlayer::intend_step(const AvatarState& avatar, Intent& intent) {
    std::visit([&](auto& playing) { intend(playing, avatar, intent); }, *playing_);
}

std::optional<StepEnd> ScriptPlayer::end_of_step(const AvatarState& avatar) {
    return std::visit([&](auto& playing) { return end_of(playing, avatar); }, *playing_);
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

template <typename Travel>
std::optional<StepEnd> ScriptPlayer::end_if_blocked(const char* verb, const Travel& step,
                                                    const Target& target, double remaining,
                                                    TravelProgress& progress,
                                                    const AvatarState& avatar) const {
    if (!progress.gives_up(remaining, avatar.grounded, speed_of(step.speed), dt_)) {
        return std::nullopt;
    }
    return StepEnd::blocked(step, target,
                            verb + (" " + target.label) + " was not reached" +
                                why_not_reached(target, step.within, progress, avatar));
}

std::string ScriptPlayer::why_not_reached(const Target& target, double within, const TravelProgress& progress,
                                          const AvatarState& avatar) const {
    const Vector3d to_target = target.point - avatar.position;
    if (flat(to_target).norm() <= within) {
        return ": it is " + fixed(std::abs(to_target.y()), 3) + " m " +
               (to_target.y() > 0.0 ? "above" : "below") + " the avatar's feet";
    }
    return progress.is_late(dt_) ? " within " + fixed(progress.allowed, 1) + " s, still " +
                                       fixed(flat(to_target).norm(), 3) + " m away"
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
