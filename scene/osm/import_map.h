#pragma once

#include <vector>

#include "scene/model/model.h"
#include "scene/osm/read/read_map.h"
#include "scene/osm/ways/campus_draft.h"

namespace campuswalk::scene::osm {

struct MapRequest {
    SourceMark mark;                ///< of messages: the map as the user named it, which says its format
    std::filesystem::path file;     ///< of OpenStreetMap XML or PBF
    SourceMark heights_mark;        ///< likewise of the heights
    std::filesystem::path heights;  ///< a grid of heights; empty: level ground
    MapSection section;
};

struct ImportedMap {
    Model model;
    CampusDraft draft;
    std::vector<Diagnostic> warnings;
};

/// Makes a campus from a map: the same bytes give the same campus. Throws InputError as read_map does, and
/// bad-heights. Call it in a process of its own (helper/), as maps are untrusted.
ImportedMap import_map(const MapRequest& request);

}  // namespace campuswalk::scene::osm
