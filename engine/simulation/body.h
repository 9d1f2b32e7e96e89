#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "collision/base/query_statistics.h"
#include "collision/mover/mover.h"
#include "engine/script/avatar.h"
#include "engine/script/intent.h"
#include "engine/script/walk.h"
#include "engine/simulation/stuck_watch.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// How far above a written-down place the avatar looks for a free one, metres (see nearest_free_placement).
/// Ground is looked for twice as far below what it found, so at least as far below what was written.
constexpr double kPlacementSearch = 0.5;

/// Out of what the avatar was pushed where it was put down.
struct Push {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    double distance = 0.0;  ///< metres
    collision::ObjectId out_of{};
};

/// What a tick's intent came to.
struct Motion {
    std::optional<Push> push;
    bool jumped = false;
    std::optional<double> landed_from;  ///< metres; of a jump, or a fall worth an event
    bool stuck = false;                 ///< has turned out to be stuck in this tick
};

/// The avatar's body among the campus' solids: the only place that knows where it is.
class Body {
public:
    /// `disabled` (by object) may change: see adjust_to_enabled and adjust_to_disabled. All must outlive the
    /// body.
    Body(const scene::Campus& campus, const Walk& walk, const std::vector<bool>& disabled);

    AvatarState state() const;
    const Eigen::Vector3d& foot() const { return mover_state_.foot; }
    double height() const { return mover_.height(); }
    double distance() const { return distance_; }  ///< metres so far, along the path of the foot point
    /// How it came to where it is: of the last tick, or of having been put down.
    const collision::MoveTrace& trace() const { return trace_; }
    /// The object beside the body that is nearest to it.
    std::optional<collision::ObjectId> obstacle() const;
    bool has_fallen_off_the_world() const;

    /// One tick.
    Motion follow(const Intent& intent, collision::QueryStatistics& statistics);

    /// Crouches or stands up. False, and nothing is changed, where there is no head room.
    bool resize(double height, collision::QueryStatistics& statistics);
    /// What is where the body would be, were it so tall.
    std::optional<collision::ObjectId> obstruction(double height,
                                                   collision::QueryStatistics& statistics) const;

    /// How the body took it that objects were enabled or disabled.
    struct Adjustment {
        std::optional<Push> push;
        std::optional<collision::ObjectId> enclosed_by;  ///< no room anywhere near; the body is where it was
    };
    Adjustment adjust_to_enabled(collision::QueryStatistics& statistics);
    void adjust_to_disabled(collision::QueryStatistics& statistics);

private:
    std::optional<Push> put_down(const Eigen::Vector3d& foot, collision::QueryStatistics& statistics);
    void rest(collision::QueryStatistics& statistics);

    const scene::Campus& campus_;
    const AvatarProfile& profile_;
    double dt_;
    collision::QueryFilter solids_;
    collision::CapsuleMover mover_;
    collision::MoverCache mover_cache_;
    collision::MoverState mover_state_;
    collision::MoveTrace trace_;
    double yaw_ = 0.0;
    double pitch_ = 0.0;
    bool jumping_ = false;  ///< in the air by a jump
    double distance_ = 0.0;
    StuckWatch stuck_;
};

}  // namespace campuswalk::engine
