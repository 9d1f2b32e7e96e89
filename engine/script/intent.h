#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "engine/events/event.h"
#include "engine/script/avatar.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// What the avatar should do in one tick.
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
    bool fatal = false;        ///< the walk ends here
    std::string code = {};     ///< fatal: of the failure
    std::string message = {};  ///< fatal: what went wrong; the simulation adds the obstacle
};

/// Where a simulation gets the avatar's intent from: the walk's script, a recording, another program. Only
/// `intend` and `finished` must be there; a source without steps leaves the rest as it is. Each tick calls
/// `intend` before the avatar moves, then `observe`, `settle` and, when that appended instant steps,
/// `observe` again. Walks are reproducible when a source answers the same calls in the same way.
class IntentSource {
public:
    virtual ~IntentSource() = default;

    /// For the next tick. The first intent should place the avatar; it starts in the world's origin
    /// otherwise.
    virtual Intent intend(const AvatarState& avatar) = 0;
    /// True when no tick is to follow. Asked after every tick.
    virtual bool finished() const = 0;

    /// What happened in the tick, and again what the instant steps brought.
    virtual void observe(std::span<const Event> events) { static_cast<void>(events); }
    /// The step that ended in this tick, to be logged, if one did. Appends to `instant` the steps to carry
    /// out at the tick's end, in their order; they must outlive the tick, a snapshot's also the observers.
    virtual std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const Step*>& instant) {
        static_cast<void>(avatar);
        static_cast<void>(instant);
        return std::nullopt;
    }
    /// Which line of the walk is being played; null: none in particular.
    virtual const SourceMark* mark() const { return nullptr; }
};

}  // namespace campuswalk::engine
