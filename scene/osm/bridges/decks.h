#pragma once

#include <vector>

#include "scene/osm/bridges/deck_parts.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// The slab of one of the decks, and parapets where one would fall; nodes are called "bridge/way-123".
void add_deck(const std::vector<Deck>& decks, std::size_t number, const Site& site, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
