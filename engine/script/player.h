#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/script/curve_walk.h"
#include "engine/script/intent.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Plays a walk's steps one after the other.
class ScriptPlayer final : public IntentSource {
public:
    explicit ScriptPlayer(const Walk& walk);

    bool finished() const override { return current_ >= walk_.steps.size(); }
    Intent intend(const AvatarState& avatar) override;
    /// For a wait_until.
    void observe(std::span<const Event> events) override;
    /// Ends the current step if it is done, and appends the instant steps after it. The end of a walk_to or a
    /// follow is reported, and what ends the walk.
    std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const Step*>& instant) override;
    /// Of the step that is being played; null once it is finished.
    const SourceMark* mark() const override;

private:
    struct Progress {
        Tick ticks = 0;                   ///< spent on the current step
        Tick since_closer = 0;            ///< ticks since the target came nearer
        double nearest = 1e300;           ///< least distance to the target so far, metres
        std::optional<double> turn_left;  ///< radians
        bool aligned = false;             ///< turn and look_at: looking where asked
        double allowed = 0.0;             ///< walk_to and follow: seconds before it gives up
        bool jumped = false;
        bool heard = false;  ///< wait_until: the event
    };

    enum class Outcome { going, done, arrived, blocked, timed_out };
    // What to do for a step in a tick, and what came of it: player.cpp says so for each kind.
    template <typename Kind>
    void intend(const Kind& step, const AvatarState& avatar, Intent& intent) = delete;
    template <typename Kind>
    Outcome outcome(const Kind& step, const AvatarState& avatar) = delete;
    /// Instant steps are carried out after the step before them; the first step is always a spawn.
    template <InstantStep Kind>
    void intend(const Kind&, const AvatarState&, Intent&) {}
    template <InstantStep Kind>
    Outcome outcome(const Kind&, const AvatarState&) {
        return Outcome::done;
    }
    std::optional<StepEnd> end_of(const Step& step, Outcome result, const AvatarState& avatar) const;

    double turned(double from, double to) const;
    double speed_of(const std::optional<double>& own) const;
    void go_towards(const Eigen::Vector3d& point, double speed, const AvatarState& avatar, Intent& intent);
    /// Whether someone who has `remaining` metres to go is late or comes no nearer.
    bool gives_up(double remaining, double speed);
    std::string why_not_reached(const Target& target, double within, const AvatarState& avatar) const;

    const Walk& walk_;
    double dt_;
    std::size_t current_ = 0;
    Progress progress_;
    std::optional<double> pace_;  ///< metres a second, once a step has set it
    CurveWalk curve_;
};

}  // namespace campuswalk::engine
