#pragma once

#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/osm/import_map.h"

namespace campuswalk::scene::osm {

/// An imported map as the contents of files, and what a walk through it can visit.
struct MapFiles {
    std::string glb;
    std::string campus_yaml;
    std::string attribution;
    std::vector<DraftSpawn> spawns;
    std::vector<DraftPlace> places;
    std::size_t buildings = 0;  ///< that have a title, and facilities
    std::size_t triangles = 0;
    std::vector<Diagnostic> warnings;
};

/// The map's file is named in the texts.
MapFiles files_of(const ImportedMap& imported, const std::string& name);

}  // namespace campuswalk::scene::osm
