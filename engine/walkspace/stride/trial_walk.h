#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "collision/mover/mover.h"
#include "engine/script/route.h"
#include "engine/walkspace/stride/stride.h"

namespace campuswalk::engine {

/// Walks pieces of routes to see where they end. Bit for bit what the avatar of a walk does, from the same
/// state: it moves and arrives and gives up by the law of the step walk_to.
class TrialWalk {
public:
    struct End {
        collision::MoverState state;
        double falls = 0.0;    ///< the heights of all that are higher than a step, metres
        bool touched = false;  ///< a solid beside it, other than one that it left
    };

    /// The world, and what `filter` points to, must outlive it. No walk to a point may
    /// lead where `keep_out` is true.
    TrialWalk(const collision::World& world, const StrideSettings& settings,
              const collision::QueryFilter& filter, std::function<bool(const collision::Vec3&)> keep_out);

    /// As a spawn puts the body down; it may be in the air. None if there is no free place.
    std::optional<collision::MoverState> put_down(const collision::Vec3& foot);
    /// None if it doesn't arrive within `most` ticks, or touches something that it may not touch. Sets the
    /// piece's ticks.
    std::optional<End> walk(const collision::MoverState& from, RoutePiece& piece, Tick most, bool may_touch);
    /// The piece's displacement, for its ticks; without any, until the body has landed. None if it falls out
    /// of the world.
    std::optional<End> stride(const collision::MoverState& from, RoutePiece& piece);

    /// The feet at the end of each tick of the last call.
    const std::vector<collision::Vec3>& path() const { return path_; }

private:
    void begin(const collision::MoverState& from);
    bool tick(const collision::Vec3& desired);
    End end() const;
    double fall_to(double y) const;

    const collision::World* world_;
    StrideSettings settings_;
    collision::QueryFilter filter_;
    std::function<bool(const collision::Vec3&)> keep_out_;
    double bottom_;  ///< below this nothing is left to land on
    collision::CapsuleMover mover_;
    collision::MoverCache cache_;
    collision::MoverState state_;
    collision::MoveTrace trace_;
    std::vector<collision::Vec3> path_;
    double stood_at_ = 0.0;  ///< the height of what last carried it
    double falls_ = 0.0;
    bool touched_ = false;
    bool is_leaving_ = false;  ///< it has touched something in each tick so far
};

}  // namespace campuswalk::engine
