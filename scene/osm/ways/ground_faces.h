#pragma once

#include <vector>

#include "scene/osm/ways/ground.h"

namespace campuswalk::scene::osm {

/// The part of a surface in a tile of the ground.
struct GroundPiece {
    const Surface* surface = nullptr;
    Polygons area;
};

/// Upright faces, the node `kerbs`, from the edges of pieces that lie lower up to what is beside them; what
/// isn't in a piece is at 0. The tile's own edges have none.
void add_faces(const std::vector<GroundPiece>& pieces, const Box& tile, const Terrain& terrain,
               ModelBuilder& model);

}  // namespace campuswalk::scene::osm
