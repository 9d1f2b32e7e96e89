#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/script/curve_walk.h"
#include "engine/script/intent.h"
#include "engine/script/route_planner.h"
#include "engine/script/step.h"
#include "engine/script/travel.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// A step that is played. Kinds of which something must be remembered from tick to tick have a
/// specialization.
template <typename Kind>
struct Playing {
    const Kind& step;
};

template <>
struct Playing<WalkToStep> {
    const WalkToStep& step;
    TravelProgress progress = {};
};

template <>
struct Playing<FollowStep> {
    const FollowStep& step;
    TravelProgress progress = {};
    CurveWalk curve = {};
};

template <>
struct Playing<GoToStep> {
    const GoToStep& step;
    TravelProgress progress = {};
    PlannedRoute planned = {};
    std::size_t piece = 0;  ///< of the route: the one that is walked
    Tick piece_ticks = 0;   ///< spent on it
};

template <>
struct Playing<JumpStep> {
    const JumpStep& step;
    bool jumped = false;
};

template <>
struct Playing<WaitStep> {
    const WaitStep& step;
    Tick ticks = 0;
};

template <>
struct Playing<WaitUntilStep> {
    const WaitUntilStep& step;
    Tick ticks = 0;
    bool event_came = false;
};

template <>
struct Playing<TurnStep> {
    const TurnStep& step;
    std::optional<double> remaining = {};  ///< radians
};

template <>
struct Playing<LookAtStep> {
    const LookAtStep& step;
    bool aligned = false;  ///< looks in the desired direction
};

template <typename Steps>
struct PlayingOneOf;

template <typename... Kinds>
struct PlayingOneOf<std::variant<Kinds...>> {
    using Variant = std::variant<Playing<Kinds>...>;
};

using PlayingStep = PlayingOneOf<Step>::Variant;

/// Plays a walk's steps one after another.
class ScriptPlayer final : public IntentSource {
public:
    /// `routes` is asked when a go_to begins; null for a walk without any. Both must outlive the player.
    explicit ScriptPlayer(const Walk& walk, RoutePlanner* routes = nullptr);

    bool finished() const override { return current_ >= walk_.steps.size(); }
    Intent intend(const AvatarState& avatar) override;
    /// Looks for the event of a wait_until.
    void on_events(std::span<const Event> events) override;
    /// Ends the current step if it is done, and appends the instant steps after it. Reports the end of a
    /// walk_to or a follow, and failures.
    std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const Step*>& instant) override;
    std::size_t steps_over() const override { return current_; }
    /// Returns the mark of the current step; null once the walk is finished.
    const SourceMark* mark() const override;

private:
    void begin_step();
    void intend_step(const AvatarState& avatar, Intent& intent);
    /// None while the step goes on.
    std::optional<StepEnd> end_of_step(const AvatarState& avatar);

    // Specialized for each kind of step in lasting_steps.cpp: a kind that isn't doesn't compile. `intent`
    // comes with the avatar's yaw and pitch and no motion.
    template <typename Kind>
    void intend(Playing<Kind>& playing, const AvatarState& avatar, Intent& intent) = delete;
    template <typename Kind>
    std::optional<StepEnd> end_of(Playing<Kind>& playing, const AvatarState& avatar) = delete;
    /// Instant steps are executed after the step before them; the first step is always a spawn.
    template <InstantStep Kind>
    void intend(Playing<Kind>&, const AvatarState&, Intent&) {}
    template <InstantStep Kind>
    std::optional<StepEnd> end_of(Playing<Kind>&, const AvatarState&) {
        return StepEnd::unlogged();
    }

    /// `from` turned towards `to` the short way, by at most what a tick allows, radians.
    double turned(double from, double to) const;
    double speed_of(const std::optional<double>& own) const;
    void go_towards(const Eigen::Vector3d& point, double speed, const AvatarState& avatar, Intent& intent);
    /// Ends a walk_to or a follow that has `remaining` metres to go and gets no nearer; none while it goes
    /// on.
    template <typename Travel>
    std::optional<StepEnd> end_if_blocked(const char* verb, const Travel& step, const Target& target,
                                          double remaining, TravelProgress& progress,
                                          const AvatarState& avatar) const;
    std::string why_not_reached(const Target& target, double within, const TravelProgress& progress,
                                const AvatarState& avatar) const;

    const Walk& walk_;
    RoutePlanner* routes_;
    double dt_;
    std::size_t current_ = 0;
    std::optional<PlayingStep> playing_;  ///< the current step
    std::optional<double> speed_;         ///< metres per second, once a step has set it
};

/// Simulated seconds that the walk's steps take if nothing is in the way and the ground is level; none for a
/// walk that waits for an event.
std::optional<double> planned_seconds(const Walk& walk);

}  // namespace campuswalk::engine
