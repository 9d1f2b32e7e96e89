#pragma once

#include <string>

#include "scene/osm/ways/compose.h"

namespace campuswalk::scene::osm {

/// What an element with a name tells visitors: title, kind, opening hours, floors, address, …
DraftBuilding description_of(const std::string& id, const Tags& tags);

/// Adds buildings, facilities, stops and works of art that have a name, with triggers around them; doors at
/// entrances, with places in front of them; spawns at gates and stops, and one in the middle.
void add_meaning(Composition& composition);

}  // namespace campuswalk::scene::osm
