#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/osm/geometry/model_builder.h"
#include "scene/osm/geometry/plan_geometry.h"
#include "scene/osm/geometry/terrain.h"

namespace campuswalk::scene::osm {

/// A surface that falls evenly.
struct Fall {
    Point from = Point::Zero();
    Point down = Point(1, 0);  ///< unit
    double slope = 0.0;        ///< metres down for each metre along
};

/// What covers the ground in an area.
struct Surface {
    std::string name;  ///< of the node
    Polygons area;
    Look look;
    int priority = 0;     ///< the higher covers the lower; of equals, the first
    double level = 0.0;   ///< metres above the ground: 0, or below it, such as a carriageway between kerbs
    bool hollow = false;  ///< nothing: something else is built there
    bool water = false;   ///< the look is that of the water, into which visitors fall down to the level
    std::optional<Fall> fall = {};  ///< its level is that at `from`

    double level_at(const Point& p) const {
        return fall ? level - fall->slope * fall->down.dot(p - fall->from) : level;
    }
};

/// Divides a box of the ground among surfaces, each point to one: there are neither gaps nor overlaps. What
/// no surface covers is the node `ground`. Where levels differ there are upright faces, the node `kerbs`.
void add_ground(const std::vector<Surface>& surfaces, const Box& box, const PlanGeometry& geometry,
                const Terrain& terrain, ModelBuilder& model);

}  // namespace campuswalk::scene::osm
