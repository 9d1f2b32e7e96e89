#pragma once

#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// Trees, benches, lamps, bins, bicycle stands, signs and the like, solid; none on the middle of a path or in
/// a building.
Built add_furniture(const Site& site, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
