#pragma once

#include "scene/osm/meaning/triggers.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// `start` on the path nearest to the middle that has room around it, or on open ground; others at gates,
/// which they face, and at stops, from which they look at what there is to see.
void add_spawns(const Site& site, const FreeGround& free, CampusDraft& draft);

/// Whether tags are those of a stop of public transport, or of taxis.
bool is_stop(const Tags& tags);

}  // namespace campuswalk::scene::osm
