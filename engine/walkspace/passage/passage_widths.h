#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// For each node, by its number (NodeNumbers), how much room there is between what is beside a visitor on the
/// one side and what is on the other, from about half its height upwards, metres: the width of the passage
/// that the node is in. Steps, low things and ceilings make no place narrow, nor do walls that meet in a
/// corner. At least the body's own width, at most `widest`.
std::vector<float> passage_widths(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                  const WalkSpace& space, double widest);

/// One of the two things that a passage is between.
struct PassageSide {
    collision::ObjectId object{};
    collision::Vec3 at = collision::Vec3::Zero();  ///< where it is nearest to the other one
};

struct PassageWidth {
    collision::Vec3 foot = collision::Vec3::Zero();  ///< between the two
    double width = 0.0;                              ///< metres
    std::array<PassageSide, 2> sides = {};
};

/// Where the passage that a body stands in is narrowest, within its radius, and how wide it is there: to a
/// millimetre. None if there aren't two things beside it less than `widest` apart.
std::optional<PassageWidth> narrowest_near(const collision::World& world, const ExploreSettings& settings,
                                           const collision::Vec3& foot, double widest);

}  // namespace campuswalk::engine
