#pragma once

#include <filesystem>

#include "scene/base/diagnostic.h"
#include "scene/model/projection.h"
#include "scene/osm/geometry/terrain.h"
#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

/// The ground of a box from a grid of heights in degrees: an Esri ASCII grid (.asc), or a tile of SRTM (.hgt)
/// whose name says where it is, such as N48E011.hgt. Heights are relative to that of the box's centre,
/// between the grid's points bilinear. The name of `mark` says which of the two it is, and where. Throws
/// InputError there: missing-file, bad-heights (damaged, or it doesn't cover the box).
Terrain read_heights(const std::filesystem::path& file, const SourceMark& mark, const Map& map,
                     const Box& box);

}  // namespace campuswalk::scene::osm
