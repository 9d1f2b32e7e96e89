#include "scene/osm/helper/map_files.h"

#include <algorithm>

#include "scene/export/named_glb.h"

namespace campuswalk::scene::osm {

MapFiles files_of(const ImportedMap& imported, const std::string& name) {
    std::string map_file = name;  // in a comment and in code of Markdown
    std::ranges::replace_if(
        map_file, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '`'; }, '_');
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
