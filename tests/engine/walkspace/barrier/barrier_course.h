#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision/world/world.h"
#include "engine/walkspace/barrier/why_not.h"

namespace campuswalk::engine {

/// A corridor of 3 m x 8 m between walls with one built barrier in its middle, turned by any angle and moved
/// anywhere; what `why_not` has to find out is known from how it was built.
struct BarrierCase {
    std::string name;
    std::unique_ptr<collision::World> world;
    collision::Vec3 start = collision::Vec3::Zero();  ///< feet
    collision::Vec3 goal = collision::Vec3::Zero();   ///< feet, beyond
    ReasonKind kind = ReasonKind::riser;
    double measured = 0.0;                      ///< metres, or radians of a slope
    std::optional<collision::ObjectId> object;  ///< that must be named
    std::optional<double> opening;              ///< beside an object: what must be measured as well
};

/// 200 cases: risers, ledges, slopes, openings, lintels, gates with and without an opening beside them.
std::vector<BarrierCase> barrier_course();

}  // namespace campuswalk::engine
