#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/script/mentions.h"
#include "engine/walkspace/route/ground_map.h"

namespace campuswalk::engine {

/// What ways are guessed by.
struct GuessRules {
    /// Where the body must not be, by its feet. May be empty.
    std::function<bool(const collision::Vec3& foot)> keep_out = {};
    /// Where it had rather not be: steps to there count kTightFactor times. May be empty.
    std::function<bool(const collision::Vec3& foot)> is_tight = {};
    double most_up = 0.3;  ///< from the middle of a cell to that of the next, metres
    /// Spots that a walk didn't lead to.
    std::vector<GroundMap::Spot> blocked = {};
};

/// The foot of a body is at most so far above or below the surface that it stands on, metres.
inline constexpr double kFootLevel = 0.35;

/// Whether a path may go from a height to another between two cells beside each other.
bool is_step(double from, double to, double most_up);

/// The shortest path over the map, from cell to cell, from beside a place to beside another; no step leads
/// farther down than a harmless fall. Whether it can be walked is another question. None if there is none, or
/// none near enough.
std::optional<std::vector<GroundMap::Spot>> guess_path(GroundMap& map, const collision::Vec3& from,
                                                       const Target& to, const GuessRules& rules);

}  // namespace campuswalk::engine
