#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "scene/osm/geometry/areas.h"
#include "scene/osm/geometry/box_index.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// Something that passes below a bridge.
struct Crossed {
    Point at = Point::Zero();
    Point along = Point(1, 0);   ///< unit: the direction in which it passes
    double width = 0.0;          ///< metres
    double clearance = 0.0;      ///< above it, metres
    const Path* path = nullptr;  ///< null: a railway or water
    std::size_t segment = 0;     ///< of the bridge, from its point `segment`
    double t = 0.0;              ///< along that segment, 0 to 1
};

/// What passes below a path at lower layers: paths, railways and water.
class CrossedByBridges {
public:
    CrossedByBridges(const Map& map, const std::vector<MapArea>& areas, const std::vector<Path>& paths);

    std::vector<Crossed> below(const Path& bridge) const;

private:
    struct Line {
        const MapWay* way = nullptr;
        const Path* path = nullptr;
        double layer = 0.0;
        double width = 0.0;
        double clearance = 0.0;
    };
    void add_water(const Path& bridge, std::vector<Crossed>& found) const;

    std::vector<Line> lines_;
    std::vector<std::pair<std::size_t, std::size_t>> segments_;  ///< of lines, by the point each ends at
    std::vector<const MapArea*> water_;
    BoxIndex near_segments_;  ///< into `segments_`
    BoxIndex near_water_;
};

/// A layer of the map: `layer`; without it 1 for a bridge, -1 for a tunnel that isn't a building's passage.
double layer_of(const Tags& tags);

}  // namespace campuswalk::scene::osm
