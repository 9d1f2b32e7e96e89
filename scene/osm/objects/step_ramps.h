#pragma once

#include "scene/osm/meaning/triggers.h"
#include "scene/osm/ways/flight_shape.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// The ramps beside a flight by "ramp", "ramp:wheelchair", "ramp:stroller" and "ramp:bicycle"
/// (wiki.openstreetmap.org/wiki/Key:ramp), on its right. Those for bicycles and strollers are as steep as the
/// flight; those for wheelchairs, or for nobody in particular, go on beyond its foot until they rise by one
/// in twelve, as far as there is room. One that stays steeper than one in six becomes a warning.
void add_step_ramps(const Path& path, const FlightShape& shape, const FreeGround& free, const Site& site,
                    ModelBuilder& model);

}  // namespace campuswalk::scene::osm
