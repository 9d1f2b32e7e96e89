#pragma once

#include <string>

#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// What an element with a name tells visitors: title, kind, opening hours, floors, address, …
DraftBuilding description_of(const std::string& id, const Tags& tags);

/// Adds to what is built the buildings, facilities, stops and works of art that have a name, with triggers
/// around them; doors at entrances, with places in front of them; spawns at gates and stops, and one in the
/// middle.
CampusDraft meaning_of(const Site& site, Built built, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
