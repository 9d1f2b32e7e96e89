#pragma once

#include "scene/osm/geometry/model_builder.h"
#include "scene/osm/geometry/terrain.h"

namespace campuswalk::scene::osm {

/// A solid over an area that follows the ground: from `below` metres under it to `above` metres over it.
void extrude(const Look& look, const Polygons& area, double below, double above, const PlanGeometry& geometry,
             const Terrain& terrain, ObjectMesh& mesh);

}  // namespace campuswalk::scene::osm
