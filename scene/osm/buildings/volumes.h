#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/osm/buildings/roofs.h"
#include "scene/osm/geometry/areas.h"
#include "scene/osm/geometry/terrain.h"

namespace campuswalk::scene::osm {

/// A building, or the part of one, as a solid: Simple 3D Buildings.
struct Volume {
    ElementId id;
    std::size_t building = 0;  ///< the area that it belongs to: itself, or a part's outline
    std::string node;          ///< its name in the model
    Tags tags;
    Polygons footprint;
    double base = 0.0;    ///< the ground that heights are measured from
    double bottom = 0.0;  ///< above the base: min_height
    double eaves = 0.0;   ///< above the base: where the roof begins
    double top = 0.0;     ///< above the base
    double storey = 3.0;  ///< height of a level, for windows
    Roof roof;
    bool open = false;  ///< a roof on posts, without walls
};

/// The volumes of all buildings in order of the areas. Of an outline with parts only what they leave is kept.
/// What can't be built as tagged becomes a warning.
std::vector<Volume> volumes_of(const std::vector<MapArea>& areas, const PlanGeometry& geometry,
                               const Terrain& terrain, const SourceMark& mark, DiagnosticList& warnings);

/// Whether an area is a building with walls or a roof above the ground.
bool is_building(const Tags& tags);

/// Whether tags are those of a roof without walls.
bool is_roof_on_posts(const Tags& tags);

/// The value of "building", or else of "building:part".
std::string_view building_kind(const Tags& tags);

}  // namespace campuswalk::scene::osm
