#include "engine/expect/walk_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <variant>

#include "collision/mover/mover_settings.h"
#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// The most seconds that a step takes by its own numbers, without its last tick.
struct LongestStep {
    const AvatarProfile& avatar;
    double speed;                                   ///< of steps that set none
    std::function<double(const Target&)> distance;  ///< horizontal, at most

    double operator()(const WalkToStep& step) const {
        return step.timeout.value_or(default_timeout(distance(step.target), step.speed.value_or(speed)));
    }
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
    : campus_(campus),
      walk_(walk),
      step_events_(campus, walk),
      speed_(walk.avatar.speed),
      fastest_(walk.avatar.speed) {
    if (!campus.objects.empty()) {
        region_ = campus.world.bounds();
    }
    if (const auto* spawn = walk.steps.empty() ? nullptr : std::get_if<SpawnStep>(&walk.steps.front())) {
        start_.extend(spawn->position);
        start_ = start_.grown(kPlacementSearch);
        region_.extend(start_);
    }
}

void WalkBounds::come_to(std::size_t steps) {
    for (; steps_ < std::min(steps, walk_.steps.size()); ++steps_) {
        add(walk_.steps[steps_]);
    }
    steps_ = steps;
}

void WalkBounds::add(const Step& step) {
    const double tick = 1.0 / walk_.sim.ticks_per_second;
    if (const auto place = preview_of(step).place) {
        collision::Aabb around;
        around.extend(place->position);
        region_.extend(around.grown(kPlacementSearch));
    }
    if (const auto* jump = std::get_if<JumpStep>(&step)) {
        const double height = 0.5 * jump->speed * jump->speed / collision::MoverSettings().gravity;
        highest_jump_ = std::max(highest_jump_, height);
    }
    if (const auto* wait = std::get_if<WaitStep>(&step)) {
        waited_ += std::max(0.0, wait->seconds - tick);  // which it may lack by rounding
    }
    if (const auto* speed = std::get_if<SpeedStep>(&step)) {
        speed_ = speed->speed;
    }
    fastest_ = std::max(fastest_, std::visit(FastestStep{}, step));
    moves_ = moves_ || moves_avatar(step);
    const auto distance_of = [this](const Target& target) {
        return distance({target.label, target.point, false}).most + fastest_ * longest_fall();
    };
    longest_ += std::visit(LongestStep{walk_.avatar, speed_, distance_of}, step) + tick;
}

Interval WalkBounds::seconds() const {
    const double tick = 1.0 / walk_.sim.ticks_per_second;
    return {waited_, std::min({longest_, walk_.timeout.value_or(kUnbounded) + tick,
                               static_cast<double>(walk_.sim.max_ticks) * tick})};
}

double WalkBounds::ticks() const {
    return seconds().most * walk_.sim.ticks_per_second + 1.0;
}

/// From the top of all to below all.
double WalkBounds::longest_fall() const {
    const double drop = region_.empty() ? 0.0 : region_.max.y() + highest_jump_ - region_.min.y() + 1000.0;
    return std::sqrt(2.0 * drop / collision::MoverSettings().gravity);
}

/// In a tick it walks, is lifted or lowered by a step, and falls.
double WalkBounds::metres() const {
    const double falling = collision::MoverSettings().gravity * longest_fall();
    return ticks() * ((fastest_ + falling) / walk_.sim.ticks_per_second + 2.0 * walk_.avatar.step_height);
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
    if (comes_of_campus(event)) {
        // An object enters, stays or leaves in three modes, and its building's window opens or closes.
        const double in_a_tick = 12.0 * static_cast<double>(campus_.objects.size()) + 16.0;
        times.most += ticks() * in_a_tick;
    }
    return times;
}

bool WalkBounds::comes_of_campus(const EventPattern& event) const {
    return std::ranges::any_of(event_kinds(), [&](EventKind kind) {
        return !StepEvents::is_caused_by_steps(kind) && scene::glob_matches(event.kind, name_of(kind)) &&
               can_be_about(kind, event.object);
    });
}

bool WalkBounds::can_be_about(EventKind kind, const std::string& glob) const {
    using enum EventKind;
    switch (kind) {
        case collision_enter:
        case collision_stay:
        case collision_exit:
            return can_contact(collision::Detection::solid, glob);
        case trigger_enter:
        case trigger_stay:
        case trigger_exit:
            return can_contact(collision::Detection::trigger, glob);
        case ray_enter:
        case ray_stay:
        case ray_exit:
            return walk_.avatar.look_distance > 0.0 && can_contact(collision::Detection::ray, glob);
        case popup_open:
        case popup_close:
            return std::ranges::any_of(campus_.objects, [&](const scene::CampusObject& object) {
                return object.popup && object.building &&
                       scene::glob_matches(glob, campus_.description.buildings[*object.building].id);
            });
        default:
            return scene::glob_matches(glob, walk_.name) && !(in_step() && kind == avatar_fell);
    }
}

bool WalkBounds::can_contact(collision::Detection detection, const std::string& glob) const {
    const std::uint32_t ignored = ignored_layers(campus_, walk_.avatar);
    for (std::size_t i = 0; i < campus_.objects.size(); ++i) {
        const collision::Object& object = campus_.world.object(static_cast<collision::ObjectId>(i));
        if (any_of(object.detection, detection) && (ignored >> object.layer & 1U) == 0 &&
            scene::glob_matches(glob, campus_.objects[i].id)) {
            return true;
        }
    }
    return false;
}

bool WalkBounds::can_come(const std::vector<EventPattern>& in_order) const {
    std::vector<bool> at_any_time;
    for (const EventPattern& event : in_order) {
        at_any_time.push_back(comes_of_campus(event));
    }
    return step_events_.can_come(in_order, at_any_time, steps_);
}

bool WalkBounds::can_follow_fall(const EventPattern& event) const {
    using enum EventKind;
    return std::ranges::any_of(
        std::array{walk_end, avatar_stuck, collision_exit, trigger_exit, ray_exit, popup_close},
        [&](EventKind kind) {
            return !(in_step() && kind == walk_end) && scene::glob_matches(event.kind, name_of(kind));
        });
}

Interval WalkBounds::distance(const Target& target) const {
    collision::Aabb region = region_;
    region.max.y() += region.empty() ? 0.0 : highest_jump_;
    return distance_to(region, target);
}

Interval WalkBounds::distance_at_start(const Target& target) const {
    return start_.empty() ? distance(target) : distance_to(start_, target);
}

}  // namespace campuswalk::engine
