#pragma once

#include <optional>
#include <vector>

#include "scene/osm/geometry/terrain.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// A place along a flight of steps, and the direction of the two edges there.
struct Station {
    Point at = Point::Zero();
    Point left = Point(0, 1);  ///< half a width long
};

struct FlightShape {
    std::vector<Station> stations;  ///< the ends of treads, from the foot
    std::optional<Station> beyond;  ///< where it ends below the deck that it leads to
    double foot = 0.0;              ///< heights
    double top = 0.0;
    bool reversed = false;  ///< it leads down as drawn

    std::size_t treads() const { return stations.size() - 1; }
    double riser() const { return (top - foot) / static_cast<double>(treads()); }
};

/// From the ground, or the bridge, at its lower end to that at its higher.
FlightShape shape_of(const Path& path, const Terrain& terrain);

/// Whether a flight rises enough on this terrain to have treads, and doesn't leave the ground.
bool has_treads(const Path& path, const Terrain& terrain);

/// The area of a flight in the plan.
Ring outline_of_steps(const Path& path);
/// The same of its treads: a chord at each, where it bends.
Ring outline_of_treads(const Path& path, const Terrain& terrain);

}  // namespace campuswalk::scene::osm
