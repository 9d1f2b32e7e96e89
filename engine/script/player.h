#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/frame_record.h"
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
};

/// How a step ended.
struct StepEnd {
    EventKind kind = EventKind::avatar_arrive;  ///< or avatar_blocked
    const std::string* label = nullptr;
    const SourceMark* mark = nullptr;
    bool fatal = false;  ///< the walk ends here
    std::string why;     ///< blocked: what a message adds to "was not reached", if anything but an obstacle
};

/// Plays a walk's steps one after the other: `intend` before the avatar moves, `settle` after it.
class ScriptPlayer {
public:
    explicit ScriptPlayer(const Walk& walk);

    bool finished() const { return current_ >= walk_.steps.size(); }
    Intent intend(const AvatarState& avatar);
    /// Ends the current step if it is done, and takes the snapshots that follow it (appended). The end of a
    /// walk_to is reported.
    std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const SnapshotStep*>& snapshots);
    /// No further step is played.
    void abandon() { current_ = walk_.steps.size(); }

private:
    struct Progress {
        Tick ticks = 0;                   ///< spent on the current step
        Tick since_closer = 0;            ///< ticks since the target came nearer
        double nearest = 1e300;           ///< least distance to the target so far, metres
        std::optional<double> turn_left;  ///< radians
        bool aligned = false;             ///< turn and look_at: looking where asked
        double allowed = 0.0;             ///< walk_to: seconds before it gives up
    };

    void intend(const SpawnStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const TeleportStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const WalkToStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const WaitStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const TurnStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const LookAtStep& step, const AvatarState& avatar, Intent& intent);
    void intend(const SnapshotStep& step, const AvatarState& avatar, Intent& intent);

    enum class Outcome { going, done, arrived, blocked };
    std::string why_not_reached(const WalkToStep& step, const AvatarState& avatar) const;
    Outcome outcome(const SpawnStep& step, const AvatarState& avatar);
    Outcome outcome(const TeleportStep& step, const AvatarState& avatar);
    Outcome outcome(const WalkToStep& step, const AvatarState& avatar);
    Outcome outcome(const WaitStep& step, const AvatarState& avatar);
    Outcome outcome(const TurnStep& step, const AvatarState& avatar);
    Outcome outcome(const LookAtStep& step, const AvatarState& avatar);
    Outcome outcome(const SnapshotStep& step, const AvatarState& avatar);

    double turned(double from, double to) const;

    const Walk& walk_;
    double dt_;
    std::size_t current_ = 0;
    Progress progress_;
};

}  // namespace campuswalk::engine
