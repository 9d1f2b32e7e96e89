#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "engine/events/event.h"
#include "engine/script/avatar.h"
#include "engine/script/failure_codes.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// What the avatar should do in one tick.
struct Intent {
    Eigen::Vector3d move = Eigen::Vector3d::Zero();  ///< horizontal displacement, metres
    double yaw = 0.0;                                ///< at the end of the tick, radians
    double pitch = 0.0;                              ///< at the end of the tick, radians
    /// Set if the avatar is put somewhere instead of moving there.
    struct Placement {
        const std::string* label = nullptr;
        Eigen::Vector3d foot = Eigen::Vector3d::Zero();
        EventKind kind = EventKind::avatar_spawn;
    };
    std::optional<Placement> placement;
    std::optional<double> jump;  ///< leaves the ground at this speed, metres per second
};

/// How a step ended.
struct StepEnd {
    std::optional<EventKind> kind = {};  ///< avatar_arrive or avatar_blocked; none: not logged
    const SourceMark* mark = nullptr;
    const Target* target = nullptr;     ///< with a kind: where the avatar arrived, or didn't get to
    double within = 0.0;                ///< avatar_blocked: so many metres of the target, horizontal
    bool fatal = false;                 ///< the walk ends here
    std::string code = {};              ///< fatal: of the failure
    std::string message = {};           ///< fatal: what went wrong, without the reason
    std::optional<Reason> reason = {};  ///< fatal: if that is known; else the simulation measures it

    // One for each way to end. Mark and target must outlive the tick.

    static StepEnd unlogged() { return {}; }
    static StepEnd arrived(const SourceMark& mark, const Target& target) {
        return {.kind = EventKind::avatar_arrive, .mark = &mark, .target = &target};
    }
    /// `step` is a walk_to or a follow to `target`.
    template <typename Travel>
    static StepEnd blocked(const Travel& step, const Target& target, const std::string& message) {
        return {.kind = EventKind::avatar_blocked,
                .mark = &step.mark,
                .target = &target,
                .within = step.within,
                .fatal = step.if_blocked == IfBlocked::fail,
                .code = std::string(kBlockedCode),
                .message = message};
    }
    static StepEnd failed(const SourceMark& mark, std::string_view code, std::string message,
                          std::optional<Reason> reason = {}) {
        return {.mark = &mark,
                .fatal = true,
                .code = std::string(code),
                .message = std::move(message),
                .reason = std::move(reason)};
    }
};

/// Where a simulation gets the avatar's intent from: the walk's script, a recording, another program. A
/// source without steps overrides only `intend` and `finished`. Each tick calls `intend` before the avatar
/// moves, then `on_events`, `settle` and, if that appended instant steps, `on_events` again. Walks are
/// reproducible if the source answers the same calls in the same way.
class IntentSource {
public:
    virtual ~IntentSource() = default;

    /// For the next tick. The first intent should place the avatar; otherwise it starts at the world's
    /// origin.
    virtual Intent intend(const AvatarState& avatar) = 0;
    /// True if no tick is to follow. Called after every tick.
    virtual bool finished() const = 0;

    /// The events of the tick; called again with those of the instant steps.
    virtual void on_events(std::span<const Event> events) { static_cast<void>(events); }
    /// How a step ended, if one did in this tick and that is to be logged. Appends to `instant` the steps to
    /// execute at the end of the tick, in their order; they must outlive the tick, snapshot steps the
    /// observers too.
    virtual std::optional<StepEnd> settle(const AvatarState& avatar, std::vector<const Step*>& instant) {
        static_cast<void>(avatar);
        static_cast<void>(instant);
        return std::nullopt;
    }
    /// How many of the walk's steps are over; the next one is in progress. 0 without steps.
    virtual std::size_t steps_over() const { return 0; }
    /// The line of the walk that is being played; null if there is none.
    virtual const SourceMark* mark() const { return nullptr; }
};

}  // namespace campuswalk::engine
