#pragma once

#include <string>

#include "scene/osm/campus_draft.h"

namespace campuswalk::tools {

/// The campus file of an imported map. The draft's names are ids and its texts plain, as read_map_response
/// has checked; `map_file` is named in the first line.
std::string draft_yaml(const scene::osm::CampusDraft& draft, const std::string& map_file);

/// What the Open Database License asks for (https://www.openstreetmap.org/copyright).
std::string attribution_text(const std::string& map_file);

}  // namespace campuswalk::tools
