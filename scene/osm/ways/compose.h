#pragma once

#include "scene/osm/buildings/buildings.h"
#include "scene/osm/ways/campus_draft.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// Everything that the generators share while a map becomes a campus.
struct Composition {
    const Map& map;
    const SourceMark& mark;  ///< of warnings
    const PlanGeometry& geometry;
    const Terrain& terrain;
    const Box& ground;  ///< where the ground is: everything on it ends there
    DiagnosticList& warnings;
    ModelBuilder model = {};
    CampusDraft draft = {};
    std::vector<MapArea> areas = {};
    std::vector<Path> paths = {};
    std::vector<Volume> volumes = {};
    std::vector<Polygons> openings = {};   ///< in walls, where paths lead through
    std::vector<Polygons> obstacles = {};  ///< where nobody can stand, besides volumes
    std::vector<Polygons> flights = {};    ///< of steps, where nobody starts

    Eigen::Vector3d world(const Point& p, double above_ground = 0.0) const {
        return {p.x(), terrain.height(p) + above_ground, -p.y()};
    }
    /// A rectangle with these half sides.
    void add_obstacle(const Point& at, const Point& u, const Point& v) {
        obstacles.push_back({Polygon{{at - u - v, at + u - v, at + u + v, at - u + v}, {}}});
    }
    void add_obstacle(const Point& at, double radius) {
        add_obstacle(at, Point(radius, 0), Point(0, radius));
    }
    void warn(const char* code, const std::string& message) const { warnings.warning(mark, code, message); }
};

/// "building-123"; of a relation "building-r123", of a node "building-n123".
std::string draft_id(const std::string& word, const ElementId& id);

}  // namespace campuswalk::scene::osm
