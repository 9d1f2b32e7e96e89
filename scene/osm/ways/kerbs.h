#pragma once

#include <vector>

#include "scene/osm/ways/ground.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// Where paths reach carriageways over kerbs that aren't raised: ground that falls to the kerb's height. By
/// "kerb" of the node there or of the path, or "kerb:height"; lowered at crossings where nothing is tagged
/// (wiki.openstreetmap.org/wiki/Key:kerb).
std::vector<Surface> kerb_ramps(const Map& map, const std::vector<Path>& paths);

}  // namespace campuswalk::scene::osm
