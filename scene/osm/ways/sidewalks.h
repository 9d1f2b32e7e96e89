#pragma once

#include <vector>

#include "scene/osm/ways/ground.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// Strips beside carriageways, by "sidewalk" and "sidewalk:left", "sidewalk:right" and "sidewalk:both"
/// (wiki.openstreetmap.org/wiki/Key:sidewalk), of "sidewalk:width" or 1.8 m.
std::vector<Surface> sidewalks_of(const std::vector<Path>& paths, const PlanGeometry& geometry);

}  // namespace campuswalk::scene::osm
