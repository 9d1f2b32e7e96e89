#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/osm/buildings/buildings.h"
#include "scene/osm/geometry/areas.h"
#include "scene/osm/geometry/plan_geometry.h"
#include "scene/osm/read/map.h"
#include "scene/osm/ways/ground.h"

namespace campuswalk::scene::osm {

/// A value of "highway": how wide it usually is, and what covers what.
struct Highway {
    std::string_view value;
    double width;  ///< metres
    int priority;
    bool carriageway;  ///< between kerbs
};

/// Null if people don't use it.
const Highway* highway_of(const Tags& tags);

/// A way that people use, with its width.
struct Path {
    const MapWay* way = nullptr;
    std::string_view highway;
    double width = 2.0;
    int priority = 80;
    bool carriageway = false;  ///< between kerbs
    bool crossing = false;     ///< of a carriageway
    bool for_walkers = true;   ///< its tags let walkers in
    bool unbuilt = false;      ///< in a tunnel, or indoors
    bool indoors = false;      ///< on a floor of a building
    bool steps = false;
    bool leaves_ground = false;  ///< steps with an end where the map has no ground
    bool from_entrance = false;  ///< steps that begin at an entrance and don't end at one
    Polygons area;               ///< its ribbon in the plan; empty if unbuilt
    std::vector<double> deck;  ///< its height at each of its points, where it is above the ground; else empty
    std::optional<double> first_height;  ///< of the ends of steps that lead to a bridge; else on the ground
    std::optional<double> last_height;
    double first_trim = 0.0;  ///< metres at the ends of steps that are below a bridge's deck
    double last_trim = 0.0;

    bool is_above() const { return !deck.empty(); }
    bool hangs() const { return first_height.has_value(); }
    bool on_ground() const { return !unbuilt && !is_above(); }
};

/// The highways of a map in its box, in order. The areas say which are indoors, the box of the ground which
/// steps leave it.
std::vector<Path> paths_of(const Map& map, const std::vector<MapArea>& areas, const Box& ground,
                           const PlanGeometry& geometry);

/// Whether the tags say that something is in a tunnel, or indoors at another level than the ground's.
bool is_unbuilt(const Tags& tags);

/// Whether "foot" and "access" let people in, of paths and gates
/// (wiki.openstreetmap.org/wiki/Key:access).
bool admits_walkers(const Tags& tags);

/// Whether the tags of a node are those of an entrance.
bool is_entrance(const Tags& tags);

/// Whether the tags of a highway let people walk there.
bool open_to_walkers(const Tags& tags);

/// What is open to walkers through buildings: tagged passages, and all paths that run into one.
std::vector<Passage> passages_of(const std::vector<Path>& paths, const PlanGeometry& geometry);

}  // namespace campuswalk::scene::osm
