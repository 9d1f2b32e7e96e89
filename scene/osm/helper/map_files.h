#pragma once

#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/osm/import_map.h"

namespace campuswalk::scene::osm {

/// An imported map as it leaves the helper: the model as bytes, the rest as plain data.
struct MapFiles {
    std::string glb;
    CampusDraft draft;
    std::size_t triangles = 0;
    std::vector<Diagnostic> warnings;
};

MapFiles files_of(ImportedMap imported);

}  // namespace campuswalk::scene::osm
