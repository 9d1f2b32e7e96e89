#pragma once

#include "scene/osm/ways/compose.h"

namespace campuswalk::scene::osm {

/// Walls, fences, hedges and the like, open where gates are and where paths lead through; gates, bollards,
/// blocks and cycle barriers, at nodes and along ways. Of kinds that aren't built a warning counts the ways.
void add_barriers(Composition& composition);

}  // namespace campuswalk::scene::osm
