#pragma once

#include "scene/osm/ways/compose.h"

namespace campuswalk::scene::osm {

/// Trees, benches, lamps, bins, bicycle stands, signs and the like, solid; none on the middle of a path or in
/// a building.
void add_furniture(Composition& composition);

}  // namespace campuswalk::scene::osm
