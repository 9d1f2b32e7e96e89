#include "scene/osm/helper/map_files.h"

#include <utility>

#include "scene/export/named_glb.h"

namespace campuswalk::scene::osm {

MapFiles files_of(ImportedMap imported) {
    MapFiles files;
    files.glb = write_named_glb(imported.model);
    files.triangles = count_triangles(imported.model);
    files.draft = std::move(imported.draft);
    files.warnings = std::move(imported.warnings);
    return files;
}

}  // namespace campuswalk::scene::osm
