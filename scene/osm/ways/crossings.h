#pragma once

#include <vector>

#include "scene/osm/ways/ground.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// Stripes and refuge islands where paths cross carriageways, by "crossing:markings", "crossing" and
/// "crossing:island" of the path or of the node (wiki.openstreetmap.org/wiki/Key:crossing).
std::vector<Surface> crossing_surfaces(const Map& map, const std::vector<Path>& paths,
                                       const PlanGeometry& geometry);

}  // namespace campuswalk::scene::osm
