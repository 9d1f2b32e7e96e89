#include "engine/expect/walk_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <variant>

#include "collision/mover/mover_settings.h"
#include "engine/script/avatar_body.h"
#include "engine/script/event_pattern.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// The most seconds that a step takes by its own numbers, without its last tick.
struct LongestStep {
    const AvatarProfile& avatar;

    double operator()(const WalkToStep& step) const { return step.timeout.value_or(kUnbounded); }
    double operator()(const GoToStep& step) const { return step.timeout.value_or(kUnbounded); }
    double operator()(const FollowStep& step) const { return step.timeout.value_or(kUnbounded); }
    double operator()(const WaitStep& step) const { return step.seconds; }
    double operator()(const WaitUntilStep& step) const { return step.timeout; }
    double operator()(const TurnStep& step) const {
        return (step.absolute ? std::numbers::pi : std::abs(step.angle)) / avatar.turn_speed;
    }
    double operator()(const LookAtStep&) const { return kUnbounded; }  // what falls may turn all the time
    double operator()(const JumpStep&) const { return kUnbounded; }
    double operator()(const SpawnStep&) const { return 0.0; }
    double operator()(const TeleportStep&) const { return 0.0; }
    template <InstantStep Instant>
    double operator()(const Instant&) const {
        return 0.0;
    }
};

/// The most metres per second that a step may make of the horizontal way.
struct FastestStep {
    double operator()(const WalkToStep& step) const { return step.speed.value_or(0.0); }
    double operator()(const GoToStep& step) const { return step.speed.value_or(0.0); }
    double operator()(const FollowStep& step) const { return step.speed.value_or(0.0); }
    double operator()(const JumpStep& step) const { return step.forward + step.speed; }
    double operator()(const SpeedStep& step) const { return step.speed; }
    template <typename Other>
    double operator()(const Other&) const {
        return 0.0;
    }
};

bool moves_avatar(const Step& step) {
    const auto* jump = std::get_if<JumpStep>(&step);
    return std::holds_alternative<WalkToStep>(step) || std::holds_alternative<GoToStep>(step) ||
           std::holds_alternative<FollowStep>(step) || (jump != nullptr && jump->forward > 0.0);
}

/// By the first `steps` steps, without the tick that each may end early by rounding.
double seconds_waited(const Walk& walk, std::size_t steps) {
    double seconds = 0.0;
    for (const Step& step : std::span(walk.steps).first(steps)) {
        if (const auto* wait = std::get_if<WaitStep>(&step)) {
            seconds += std::max(0.0, wait->seconds - 1.0 / walk.sim.ticks_per_second);
        }
    }
    return seconds;
}

Interval distance_to(const collision::Aabb& box, const Target& target) {
    Eigen::Vector3d near = (box.min - target.point).cwiseMax(target.point - box.max).cwiseMax(0.0);
    Eigen::Vector3d far = (target.point - box.min).cwiseAbs().cwiseMax((box.max - target.point).cwiseAbs());
    if (!target.has_height) {
        near.y() = far.y() = 0.0;
    }
    return {near.norm(), far.norm()};
}

}  // namespace

WalkBounds::WalkBounds(const scene::Campus& campus, const Walk& walk)
    : campus_(campus), walk_(walk), step_events_(campus, walk), steps_(walk.steps.size() + 1) {
    fastest_ = walk.avatar.speed;
    if (!campus.objects.empty()) {
        region_ = campus.world.bounds();
    }
    for (const Step& step : walk.steps) {
        seconds_.most += std::visit(LongestStep{walk.avatar}, step) + 1.0 / walk.sim.ticks_per_second;
        fastest_ = std::max(fastest_, std::visit(FastestStep{}, step));
        moves_ = moves_ || moves_avatar(step);
        if (const auto place = preview_of(step).place) {
            region_.extend(place->position);
        }
    }
    if (const auto* spawn = walk.steps.empty() ? nullptr : std::get_if<SpawnStep>(&walk.steps.front())) {
        start_.extend(spawn->position);
        start_ = start_.grown(kPlacementSearch);
        region_.extend(start_);
    }
    const double tick = 1.0 / walk.sim.ticks_per_second;
    seconds_.least = seconds_waited(walk, walk.steps.size());
    seconds_.most = std::min({seconds_.most, walk.timeout.value_or(kUnbounded) + tick,
                              static_cast<double>(walk.sim.max_ticks) * tick});
    ticks_ = seconds_.most / tick + 1.0;
    // In a tick it walks, is lifted or lowered by a step, and falls no faster than from the top of all.
    const double drop = region_.empty() ? 0.0 : region_.max.y() - region_.min.y() + 1000.0;
    const double falling = std::sqrt(2.0 * collision::MoverSettings().gravity * drop);
    metres_ = ticks_ * ((fastest_ + falling) * tick + 2.0 * walk.avatar.step_height);
}

bool WalkBounds::matches_own(const EventPattern& event, EventKind kind) const {
    return scene::glob_matches(event.kind, name_of(kind)) && scene::glob_matches(event.object, walk_.name);
}

bool WalkBounds::is_only(const EventPattern& event, EventKind kind) const {
    return std::ranges::all_of(event_kinds(), [&](EventKind other) {
        return other == kind || !scene::glob_matches(event.kind, name_of(other));
    });
}

Interval WalkBounds::times(const EventPattern& event) const {
    Interval times = step_events_.times(event, steps_);
    const bool others = std::ranges::any_of(event_kinds(), [&](EventKind kind) {
        const bool stops_walk = in_step() && kind == EventKind::avatar_fell;
        return !StepEvents::is_caused_by_steps(kind) && !stops_walk &&
               scene::glob_matches(event.kind, name_of(kind));
    });
    if (others) {
        // An object enters, stays or leaves in three modes, and its building's window opens or closes.
        const double in_a_tick = 12.0 * static_cast<double>(campus_.objects.size()) + 16.0;
        times.most += ticks_ * in_a_tick;
    }
    return times;
}

bool WalkBounds::can_follow_fall(const EventPattern& event) const {
    using enum EventKind;
    return std::ranges::any_of(
        std::array{walk_end, avatar_stuck, collision_exit, trigger_exit, ray_exit, popup_close},
        [&](EventKind kind) {
            return !(in_step() && kind == walk_end) && scene::glob_matches(event.kind, name_of(kind));
        });
}

void WalkBounds::stop_before(std::size_t step) {
    steps_ = step;
    seconds_.least = seconds_waited(walk_, step);
}

Interval WalkBounds::distance(const Target& target) const {
    return distance_to(region_, target);
}

Interval WalkBounds::distance_at_start(const Target& target) const {
    return start_.empty() ? distance(target) : distance_to(start_, target);
}

}  // namespace campuswalk::engine
