#pragma once

#include "scene/osm/compose.h"

namespace campuswalk::scene::osm {

/// The treads of all flights that rise, from the ground at their foot to that at their top, and their
/// handrails. The ground is left out below them: see Surface::hollow.
void add_steps(Composition& composition);

/// The area of a flight in the plan.
Ring outline_of_steps(const Path& path);
/// The same of its treads: a chord at each, where it bends.
Ring outline_of_treads(const Path& path, const Terrain& terrain);

/// Whether a flight rises enough on this terrain to have treads.
bool has_treads(const Path& path, const Terrain& terrain);

}  // namespace campuswalk::scene::osm
