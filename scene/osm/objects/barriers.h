#pragma once

#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// Walls, fences, hedges and the like, open where gates are and where paths lead through; gates, bollards,
/// blocks and cycle barriers, at nodes and along ways. Of kinds that aren't built a warning counts the ways.
Built add_barriers(const Site& site, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
