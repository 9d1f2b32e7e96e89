#pragma once

#include <cstdint>
#include <vector>

#include "scene/osm/geometry/areas.h"
#include "scene/osm/ways/paths.h"
#include "scene/osm/ways/relief.h"

namespace campuswalk::scene::osm {

/// A path at a node of a bridge.
struct PathAtBridge {
    std::size_t path = 0;   ///< into the paths of the map
    std::size_t place = 0;  ///< of the node in it
    double height = 0.0;    ///< of the deck there
};

/// Paths above others that are connected with each other.
struct Bridge {
    std::vector<std::size_t> paths;        ///< into the paths of the map
    std::vector<std::int64_t> open_ends;   ///< nodes where other paths than steps lead on, or nothing does
    std::vector<std::int64_t> stair_ends;  ///< nodes where only steps lead on
    std::vector<PathAtBridge> leading_on;  ///< at the open ends
    std::vector<PathAtBridge> stairs;
    /// Areas of the map with man_made=bridge: how far the deck reaches beside the paths.
    std::vector<std::size_t> outlines;
    double thickness = 0.4;  ///< of its deck, metres
};

/// How paths get above others.
struct BridgePlan {
    std::vector<Bridge> bridges;    ///< those above the ground
    std::vector<Mound> mounds;      ///< by which the ground leads up to them
    std::vector<Cutting> cuttings;  ///< what passes below, where the ground stays as it is
};

/// Finds the bridges and how high they are: `bridge` or a `layer` above 0, where something passes below or
/// the ground falls away. Their decks run straight between the heights of the ground at their ends, all
/// raised until what passes below has its clearance. Sets `deck` of paths, and `hangs` of steps that lead
/// down from one. What stays at the ground, tunnels and negative layers become warnings.
BridgePlan plan_bridges(const Map& map, const std::vector<MapArea>& areas, const Terrain& base,
                        const SourceMark& mark, std::vector<Path>& paths, DiagnosticList& warnings);

/// The height of a line at its point nearest to another one on the plan, metres; `heights` are those of its
/// points.
double height_along(const std::vector<Point>& line, const std::vector<double>& heights, const Point& p);

/// How high a deck is at a point of the plan nearest to its line, metres.
double deck_height(const Path& path, const Point& p);

}  // namespace campuswalk::scene::osm
