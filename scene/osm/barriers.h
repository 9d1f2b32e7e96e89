#pragma once

#include "scene/osm/compose.h"

namespace campuswalk::scene::osm {

/// Walls, fences and hedges, open where paths and gates lead through; gates, open or closed as their tags
/// say; bollards and the like, with room to pass.
void add_barriers(Composition& composition);

/// Whether tags are those of a gate of any kind, open or closed.
bool is_gate(const Tags& tags);

}  // namespace campuswalk::scene::osm
