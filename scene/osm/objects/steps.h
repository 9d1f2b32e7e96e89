#pragma once

#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// The treads of all flights that rise, from the ground at their foot to that at their top, their handrails,
/// and the ramps beside them. The ground is left out below treads: see Surface::hollow.
Built add_steps(const Site& site, const Built& before, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
