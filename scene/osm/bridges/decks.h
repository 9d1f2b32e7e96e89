#pragma once

#include <vector>

#include "scene/osm/bridges/deck_parts.h"
#include "scene/osm/ways/compose.h"

namespace campuswalk::scene::osm {

/// The slab of one of the decks, and parapets where one would fall; nodes are called "bridge/way-123".
void add_deck(const std::vector<Deck>& decks, std::size_t number, Composition& composition);

}  // namespace campuswalk::scene::osm
