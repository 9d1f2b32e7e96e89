#pragma once

#include <optional>
#include <vector>

#include "scene/osm/buildings/volumes.h"
#include "scene/osm/geometry/model_builder.h"
#include "scene/osm/geometry/terrain.h"

namespace campuswalk::scene::osm {

/// A space through volumes that one can walk through.
struct Passage {
    const MapWay* way = nullptr;
    bool tagged = false;  ///< as a passage
    bool for_walkers = true;
    Polygons area;
    std::optional<double> floor;  ///< of a bridge; else it is at the ground
    double height = 2.5;          ///< above the floor
};

/// The walls, with windows, and the roof.
void add_volume(const Volume& volume, const std::vector<const Passage*>& passages,
                const PlanGeometry& geometry, const Terrain& terrain, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
