#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "collision/base/query_statistics.h"
#include "collision/mover/mover.h"
#include "engine/script/avatar.h"
#include "engine/script/avatar_body.h"
#include "engine/script/intent.h"
#include "engine/script/walk.h"
#include "engine/simulation/stop_reason.h"
#include "engine/simulation/stuck_watch.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// This far below all objects the avatar has fallen out of the world, metres.
inline constexpr double kAbyss = 10.0;

/// How the avatar was pushed out of an object that it was placed inside.
struct Push {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    double distance = 0.0;  ///< metres
    collision::ObjectId out_of{};
};

/// What came of the intent in a tick.
struct Motion {
    std::optional<Push> push;
    bool jumped = false;
    std::optional<double> landed_from;  ///< metres; after a jump, or a fall that is worth an event
    bool stuck = false;                 ///< found to be stuck in this tick
};

/// The avatar's body among the solids of the campus. The only place that stores its position.
class Body {
public:
    /// `disabled` (by object) may change: see adjust_to_enabled and adjust_to_disabled. All must outlive the
    /// body.
    Body(const scene::Campus& campus, const Walk& walk, const std::vector<bool>& disabled);

    AvatarState state() const;
    const Eigen::Vector3d& foot() const { return mover_state_.foot; }
    /// All that its next move depends on, besides the objects.
    const collision::MoverState& mover_state() const { return mover_state_; }
    collision::MoverSettings mover_settings() const;
    const AvatarProfile& profile() const { return profile_; }
    const collision::QueryFilter& solids() const { return solids_; }
    double height() const { return mover_.height(); }
    double distance() const { return distance_; }  ///< metres so far, along the path of the foot point
    /// How it got where it is: in the last tick, or when it was placed.
    const collision::MoveTrace& trace() const { return trace_; }
    /// The nearest of the objects that the body touches.
    std::optional<collision::ObjectId> obstacle() const;
    bool has_fallen_out_of_the_world() const;
    /// As the walk space sees it.
    StoppedBody in_place() const;
    /// Likewise on its way to `heading`; none in the air.
    std::optional<StoppedBody> stopped(const Eigen::Vector3d& heading) const;
    /// Where it last stood on the ground; none if it was in the air ever since it was placed.
    std::optional<StoppedBody> last_stood() const;

    /// One tick.
    Motion follow(const Intent& intent, collision::QueryStatistics& statistics);

    /// Crouches or stands up. False, without any change, if there is no headroom.
    bool resize(double height, collision::QueryStatistics& statistics);
    /// The object that obstructs a body of this height, if any.
    std::optional<collision::ObjectId> obstruction(double height,
                                                   collision::QueryStatistics& statistics) const;

    /// How the body reacted when objects were enabled.
    struct Adjustment {
        std::optional<Push> push;
        std::optional<collision::ObjectId> enclosed_by;  ///< no room nearby; the body hasn't moved
    };
    Adjustment adjust_to_enabled(collision::QueryStatistics& statistics);
    void adjust_to_disabled(collision::QueryStatistics& statistics);

private:
    std::optional<Push> put_down(const Eigen::Vector3d& foot, collision::QueryStatistics& statistics);
    void trace_in_place(collision::QueryStatistics& statistics);

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
    std::optional<GroundState> last_stood_;
    StuckWatch stuck_;
};

}  // namespace campuswalk::engine
