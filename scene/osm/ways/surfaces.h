#pragma once

#include <vector>

#include "scene/osm/geometry/areas.h"
#include "scene/osm/ways/ground.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// How deep carriageways lie between kerbs, metres.
inline constexpr double kKerb = 0.12;

/// How paths, squares, lawns and so on cover the ground.
std::vector<Surface> surfaces_of(const Map& map, const std::vector<Path>& paths,
                                 const std::vector<MapArea>& areas, const PlanGeometry& geometry,
                                 const Terrain& terrain);

}  // namespace campuswalk::scene::osm
