#include "engine/script/player.h"

#include <algorithm>
#include <cmath>

#include "collision/trigonometry.h"
#include "engine/decimals.h"

namespace campuswalk::engine {

using collision::angle_of;
using collision::wrapped_angle;
using Eigen::Vector3d;

namespace {

/// Standing this far above or below a target that has a height still counts as being there, metres.
constexpr double kLevel = 0.5;
/// A walk_to gives up after this many seconds in which its target came no nearer by kProgress, or by half of
/// what a slower avatar would walk in that time.
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

}  // namespace

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

std::optional<StepEnd> ScriptPlayer::settle(const AvatarState& avatar,
                                            std::vector<const SnapshotStep*>& snapshots) {
    if (finished()) {
        return std::nullopt;
    }
    const Step& step = walk_.steps[current_];
    const Outcome result = std::visit([&](const auto& s) { return outcome(s, avatar); }, step);
    if (result == Outcome::going) {
        return std::nullopt;
    }
    std::optional<StepEnd> end;
    if (const auto* walk_to = std::get_if<WalkToStep>(&step)) {
        const bool blocked = result == Outcome::blocked;
        end = StepEnd{blocked ? EventKind::avatar_blocked : EventKind::avatar_arrive, &walk_to->target.label,
                      &walk_to->mark, blocked && walk_to->if_blocked == IfBlocked::fail,
                      blocked ? why_not_reached(*walk_to, avatar) : ""};
    }
    progress_ = {};
    for (++current_; !finished(); ++current_) {
        const auto* snapshot = std::get_if<SnapshotStep>(&walk_.steps[current_]);
        if (snapshot == nullptr || (end && end->fatal)) {
            break;
        }
        snapshots.push_back(snapshot);
    }
    return end;
}

/// `from` turned towards `to` the short way, by no more than a tick's worth.
double ScriptPlayer::turned(double from, double to) const {
    const double most = walk_.avatar.turn_speed * dt_;
    const double difference = wrapped_angle(to - from);
    return std::abs(difference) <= most ? wrapped_angle(to)
                                        : wrapped_angle(from + std::clamp(difference, -most, most));
}

// ---- one overload of each a step ------------------------------------------------------------------------

void ScriptPlayer::intend(const SpawnStep& step, const AvatarState&, Intent& intent) {
    intent.placement = {&step.label, step.position, EventKind::avatar_spawn};
    intent.yaw = wrapped_angle(step.yaw);
    intent.pitch = 0.0;
}

ScriptPlayer::Outcome ScriptPlayer::outcome(const SpawnStep&, const AvatarState&) {
    return Outcome::done;
}

void ScriptPlayer::intend(const TeleportStep& step, const AvatarState& avatar, Intent& intent) {
    intent.placement = {&step.label, step.position, EventKind::avatar_teleport};
    intent.yaw = wrapped_angle(step.yaw.value_or(avatar.yaw));
}

ScriptPlayer::Outcome ScriptPlayer::outcome(const TeleportStep&, const AvatarState&) {
    return Outcome::done;
}

void ScriptPlayer::intend(const WalkToStep& step, const AvatarState& avatar, Intent& intent) {
    const Vector3d way = flat(step.target.point - avatar.position);
    const double distance = way.norm();
    const double speed = step.speed.value_or(walk_.avatar.speed);
    if (progress_.ticks == 0) {
        progress_.allowed = step.timeout.value_or(2.0 * distance / speed + 5.0);
    }
    if (distance > 0.0) {
        intent.move = way * (std::min(distance, speed * dt_) / distance);
        intent.yaw = turned(avatar.yaw, yaw_towards(way));
    }
    intent.pitch = turned(avatar.pitch, 0.0);
}

ScriptPlayer::Outcome ScriptPlayer::outcome(const WalkToStep& step, const AvatarState& avatar) {
    const Vector3d way = step.target.point - avatar.position;
    const double distance = flat(way).norm();
    if (distance <= step.within && (!step.target.has_height || std::abs(way.y()) <= kLevel)) {
        return Outcome::arrived;
    }
    const double speed = step.speed.value_or(walk_.avatar.speed);
    if (distance < progress_.nearest - std::min(kProgress, 0.5 * speed * kPatience)) {
        progress_.nearest = distance;
        progress_.since_closer = progress_.ticks;
    }
    const double idle = static_cast<double>(progress_.ticks - progress_.since_closer) * dt_;
    const bool late = static_cast<double>(progress_.ticks) * dt_ >= progress_.allowed;
    return late || idle >= kPatience ? Outcome::blocked : Outcome::going;
}

std::string ScriptPlayer::why_not_reached(const WalkToStep& step, const AvatarState& avatar) const {
    const Vector3d way = step.target.point - avatar.position;
    if (flat(way).norm() <= step.within) {
        return ": it is " + fixed(std::abs(way.y()), 3) + " m " + (way.y() > 0.0 ? "above" : "below") +
               " the avatar's feet";
    }
    const bool late = static_cast<double>(progress_.ticks) * dt_ >= progress_.allowed;
    return late ? " within " + fixed(progress_.allowed, 1) + " s, still " + fixed(flat(way).norm(), 3) +
                      " m away"
                : "";
}

void ScriptPlayer::intend(const WaitStep&, const AvatarState&, Intent&) {}

ScriptPlayer::Outcome ScriptPlayer::outcome(const WaitStep& step, const AvatarState&) {
    return static_cast<double>(progress_.ticks) >= step.seconds * walk_.sim.ticks_per_second - 1e-9
               ? Outcome::done
               : Outcome::going;
}

/// To an angle the short way; by an angle all the way, however often around.
void ScriptPlayer::intend(const TurnStep& step, const AvatarState& avatar, Intent& intent) {
    const double rest =
        progress_.turn_left.value_or(step.absolute ? wrapped_angle(step.angle - avatar.yaw) : step.angle);
    const double most = walk_.avatar.turn_speed * dt_;
    const double part = std::clamp(rest, -most, most);
    intent.yaw = wrapped_angle(avatar.yaw + part);
    progress_.turn_left = rest - part;
    progress_.aligned = std::abs(rest - part) <= kAligned;
}

ScriptPlayer::Outcome ScriptPlayer::outcome(const TurnStep&, const AvatarState&) {
    return progress_.aligned ? Outcome::done : Outcome::going;
}

void ScriptPlayer::intend(const LookAtStep& step, const AvatarState& avatar, Intent& intent) {
    const Vector3d eye = avatar.position + Vector3d(0, walk_.avatar.eye_height, 0);
    const Vector3d way = step.target.point - eye;
    const double distance = flat(way).norm();
    const double yaw = distance > 0.0 ? yaw_towards(way) : avatar.yaw;
    const double pitch = step.target.has_height ? angle_of(way.y(), distance) : 0.0;
    intent.yaw = turned(avatar.yaw, yaw);
    intent.pitch = turned(avatar.pitch, pitch);
    progress_.aligned = std::abs(wrapped_angle(intent.yaw - yaw)) <= kAligned &&
                        std::abs(wrapped_angle(intent.pitch - pitch)) <= kAligned;
}

ScriptPlayer::Outcome ScriptPlayer::outcome(const LookAtStep&, const AvatarState&) {
    return progress_.aligned ? Outcome::done : Outcome::going;
}

void ScriptPlayer::intend(const SnapshotStep&, const AvatarState&, Intent&) {}

/// Snapshots are taken in `settle` after the step before them; the first step is always a spawn.
ScriptPlayer::Outcome ScriptPlayer::outcome(const SnapshotStep&, const AvatarState&) {
    return Outcome::done;
}

}  // namespace campuswalk::engine
