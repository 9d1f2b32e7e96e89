#pragma once

#include "scene/osm/meaning/triggers.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// A door with a trigger, and a place in front of it, at each entrance in a wall: where it is tagged, and
/// where a path ends at one. Those of other floors than the ground's are where a path leads to them, on the
/// ground or a bridge, and else are left out with a warning that counts them. Of a building with a name and
/// no other, at the wall nearest to a path.
void add_doors(const Site& site, const FreeGround& free, const std::vector<Polygons>& openings,
               ModelBuilder& model, CampusDraft& draft);

}  // namespace campuswalk::scene::osm
