#pragma once

#include <vector>

#include "scene/osm/bridges/deck_parts.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// What holds bridges up where the map says so: nodes and areas with "bridge:support", from the ground to the
/// lowest deck above them; nodes are called "bridge-pier/node-123". What no deck is above becomes a warning.
Built add_piers(const std::vector<Deck>& decks, const Site& site, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
