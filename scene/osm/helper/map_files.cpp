#include "scene/osm/helper/map_files.h"

#include "scene/export/named_glb.h"

namespace campuswalk::scene::osm {

MapFiles files_of(const ImportedMap& imported, const std::string& map_file) {
    MapFiles files;
    files.glb = write_named_glb(imported.model);
    files.campus_yaml = campus_yaml(imported.draft, map_file);
    files.attribution = attribution_text(map_file);
    files.spawns = imported.draft.spawns;
    files.places = imported.draft.places;
    files.buildings = imported.draft.buildings.size();
    files.triangles = count_triangles(imported.model);
    files.warnings = imported.warnings;
    return files;
}

}  // namespace campuswalk::scene::osm
