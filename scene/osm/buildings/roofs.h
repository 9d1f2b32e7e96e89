#pragma once

#include <optional>
#include <string_view>

#include "scene/osm/geometry/model_builder.h"
#include "scene/osm/geometry/plan_geometry.h"

namespace campuswalk::scene::osm {

/// The shapes of "roof:shape" in Simple 3D Buildings (wiki.openstreetmap.org/wiki/Simple_3D_Buildings).
enum class RoofShape {
    flat,
    gabled,
    hipped,
    half_hipped,
    pyramidal,
    skillion,
    gambrel,
    mansard,
    dome,
    onion,
    round
};

/// The shape that the tag's value names; nothing if it isn't one of them.
std::optional<RoofShape> roof_shape(std::string_view word);

struct Roof {
    RoofShape shape = RoofShape::flat;
    double height = 0.0;        ///< metres above the eaves; 0: flat
    bool across = false;        ///< the ridge runs along the shorter side
    bool directed = false;      ///< `down` is given
    Point down = Point(0, -1);  ///< unit direction in which a skillion, or one side of a ridge, falls
};

/// Whether the footprint can carry the shape: a roof with a ridge needs something like a rectangle, a pyramid
/// or dome something that its middle sees all of.
bool allows(const Polygons& footprint, RoofShape shape, const PlanGeometry& geometry);

/// Half of the footprint's extent across the ridge, metres: what a slope spans.
double half_span(const Polygons& footprint, const Roof& roof, const PlanGeometry& geometry);

/// The height of a roof whose height isn't tagged, metres above the eaves.
double usual_height(RoofShape shape, double half_span);

/// The roof, and the walls between the eaves and it.
void add_roof(const Polygons& footprint, const Roof& roof, double eaves, const Look& roof_look,
              const Look& wall_look, const PlanGeometry& geometry, ObjectMesh& mesh);

}  // namespace campuswalk::scene::osm
