#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/script/route.h"
#include "engine/walkspace/route/route.h"
#include "engine/walkspace/stride/trial_walk.h"

namespace campuswalk::engine {

/// A piece of a route as it was walked.
struct WalkedPiece {
    RoutePiece piece;
    TrialWalk::End end;
    std::vector<collision::Vec3> path;
    Tick tight = 0;  ///< ticks in tight places
};

/// A route as far as it is planned, and the body at its end.
class RouteDraft {
public:
    /// Where the body has come to.
    struct Mark {
        collision::MoverState state;
        std::size_t pieces = 0;
        std::size_t points = 0;
    };

    /// The world and the settings must outlive it.
    RouteDraft(const collision::World& world, const RouteSettings& settings,
               const collision::MoverState& from);

    const collision::World& world() const { return world_; }
    const RouteSettings& settings() const { return settings_; }
    const collision::MoverState& state() const { return state_; }
    TrialWalk& trial() { return trial_; }
    Strider& strider() { return strider_; }
    const Route& route() const { return route_; }

    /// Walks on from the end of the route; see TrialWalk::walk.
    std::optional<WalkedPiece> walk(RoutePiece piece, Tick most, bool may_touch);
    void append(const WalkedPiece& walked);
    /// False if the body falls out of the world.
    bool append_stride(RoutePiece piece);
    void note_search() { route_.searched = true; }

    Mark mark() const { return {state_, route_.pieces.size(), route_.path.size()}; }
    void go_back_to(const Mark& mark);
    /// The path takes so long from there on; tight places count as in the exploration.
    Tick ticks_since(const Mark& mark) const;
    Tick tight_ticks(const std::vector<collision::Vec3>& path) const;

private:
    const collision::World& world_;
    const RouteSettings& settings_;
    Strider strider_;
    TrialWalk trial_;
    collision::MoverState state_;
    Route route_;
};

}  // namespace campuswalk::engine
