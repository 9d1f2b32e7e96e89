#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/events/event.h"
#include "engine/script/mentions.h"

namespace campuswalk::engine {

/// A piece of a route: straight to a point, as the step walk_to goes there.
struct RoutePiece {
    Target target;
    double within = 0.05;  ///< metres, horizontal
    /// Instead of that: this displacement in each of its ticks, whatever comes of it; zero: stands still.
    std::optional<Eigen::Vector3d> stride = {};
    Tick ticks = 0;  ///< that it takes
};

/// A way whose pieces have been walked, each from exactly where the one before ended: an avatar that starts
/// in the same state arrives.
struct Route {
    std::vector<RoutePiece> pieces;
    std::vector<Eigen::Vector3d> path;  ///< of the feet: the start, then the end of each tick
    bool searched = false;              ///< found by walking everywhere, which takes long

    Tick ticks() const;
    double length() const;  ///< metres
    double climb() const;   ///< of all that goes up, metres
};

}  // namespace campuswalk::engine
