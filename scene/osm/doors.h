#pragma once

#include "scene/osm/compose.h"
#include "scene/osm/triggers.h"

namespace campuswalk::scene::osm {

/// A door with a trigger, and a place in front of it, at each entrance in a wall: where it is tagged, and
/// where a path ends at one; of a building with a name and no other, at the wall nearest to a path.
void add_doors(Composition& composition, const FreeGround& free);

}  // namespace campuswalk::scene::osm
