#pragma once

#include <string>

#include "scene/osm/ways/campus_draft.h"

namespace campuswalk::tools {

/// The building's id that the place is at: the first part of its trigger's.
std::string building_of(const scene::osm::DraftPlace& place);
/// And that building's title; empty if it has none.
std::string building_title(const scene::osm::CampusDraft& draft, const scene::osm::DraftPlace& place);

/// The campus file of an imported map. The draft's names are ids and its texts plain, as read_map_response
/// has checked; `map_file` is named in the first line.
std::string draft_yaml(const scene::osm::CampusDraft& draft, const std::string& map_file);

/// What the Open Database License asks for (https://www.openstreetmap.org/copyright).
std::string attribution_text(const std::string& map_file);

}  // namespace campuswalk::tools
