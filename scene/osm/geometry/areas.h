#pragma once

#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/osm/geometry/plan_geometry.h"
#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

/// A closed way or a multipolygon relation that stands for an area.
struct MapArea {
    ElementId id;
    Tags tags;
    Polygons polygons;
    std::vector<const MapWay*> outlines;  ///< the ways that it is made of
};

/// " (Elm Hall)", for messages; empty without a name.
std::string name_in_parentheses(const Tags& tags);

/// All areas of a map that touch its box, ways before relations. Those that have no area, such as relations
/// with missing members, become warnings at `mark`.
std::vector<MapArea> areas_of(const Map& map, const PlanGeometry& geometry, const SourceMark& mark,
                              DiagnosticList& warnings);

}  // namespace campuswalk::scene::osm
