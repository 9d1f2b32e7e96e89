#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/script/avatar.h"
#include "engine/script/curve_walk.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// What the script wants of the avatar in one tick.
struct Intent {
    Eigen::Vector3d move = Eigen::Vector3d::Zero();  ///< horizontal displacement, metres
    double yaw = 0.0;                                ///< to look along at the end of the tick
    double pitch = 0.0;
    /// Set when the avatar is put somewhere instead of moving there.
    struct Placement {
        const std::string* label = nullptr;
        Eigen::Vector3d foot = Eigen::Vector3d::Zero();
        EventKind kind = EventKind::avatar_spawn;
    };
    std::optional<Placement> placement;
    std::optional<double> jump;  ///< leaves the ground at this speed, metres a second
};

/// How a step ended.
struct StepEnd {
    std::optional<EventKind> kind;  ///< avatar_arrive or avatar_blocked, with the label; none: not logged
    const std::string* label = nullptr;
    const SourceMark* mark = nullptr;
    bool fatal = false;   ///< the walk ends here
    std::string code;     ///< fatal: of the failure
    std::string message;  ///< fatal: what went wrong; an obstacle is for others to add
};

/// Plays a walk's steps one after the other: `intend` before the avatar moves, `hear` and `settle` after it.
class ScriptPlayer {
public:
    explicit ScriptPlayer(const Walk& walk);

    bool finished() const { return current_ >= walk_.steps.size(); }
    Intent intend(const AvatarState& avatar);
    /// What happened, for a wait_until: before `settle`, and again for what the effects of steps brought.
    void hear(std::span<const Event> events);
    /// Ends the current step if it is done, and appends the steps after it that take no time, which the
    /// caller carries out in their order. The end of a walk_to or a follow is reported, and what ends the
    /// walk.
    std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const Step*>& effects);
    /// Of the step that is being played; call before it is finished.
    const SourceMark& mark() const;
    /// No further step is played.
    void abandon() { current_ = walk_.steps.size(); }

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

    void intend(const SpawnStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const TeleportStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const WalkToStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const WaitStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const TurnStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const LookAtStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const FollowStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const JumpStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const WaitUntilStep& step, const AvatarState& avatar, Intent& intent);
    template <typename Effect>
    void intend(const Effect&, const AvatarState&, Intent&) {}

    enum class Outcome { going, done, arrived, blocked, timed_out };
    std::optional<StepEnd> end_of(const Step& step, Outcome result, const AvatarState& avatar) const;
    Outcome outcome(const SpawnStep& step, const AvatarState& avatar);
    Outcome outcome(const TeleportStep& step, const AvatarState& avatar);
    Outcome outcome(const WalkToStep& step, const AvatarState& avatar);
    Outcome outcome(const WaitStep& step, const AvatarState& avatar);
    Outcome outcome(const TurnStep& step, const AvatarState& avatar);
    Outcome outcome(const LookAtStep& step, const AvatarState& avatar);
    Outcome outcome(const FollowStep& step, const AvatarState& avatar);
    Outcome outcome(const JumpStep& step, const AvatarState& avatar);
    Outcome outcome(const WaitUntilStep& step, const AvatarState& avatar);
    /// Effects are carried out in `settle` after the step before them; the first step is always a spawn.
    template <typename Effect>
    Outcome outcome(const Effect&, const AvatarState&) {
        return Outcome::done;
    }

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
