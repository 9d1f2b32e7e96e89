#pragma once

#include <iterator>
#include <utility>

#include "scene/osm/buildings/buildings.h"
#include "scene/osm/ways/campus_draft.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// What stands and leads where on a map: what its objects are made from.
struct Site {
    const Map& map;
    const SourceMark& mark;  ///< of warnings
    const PlanGeometry& geometry;
    const Terrain& terrain;
    const Box& ground;  ///< where the ground is: everything on it ends there
    DiagnosticList& warnings;
    std::vector<MapArea> areas;
    std::vector<Path> paths;
    std::vector<Volume> volumes;

    Eigen::Vector3d world(const Point& p, double above_ground = 0.0) const {
        return {p.x(), terrain.height(p) + above_ground, -p.y()};
    }
    void warn(DiagnosticCode code, const std::string& message) const {
        warnings.warning(mark, code, message);
    }
};

/// What one kind of objects adds to a campus, besides their meshes.
struct Built {
    std::vector<DraftSolid> solids = {};
    std::vector<Polygons> openings = {};   ///< in walls, where paths lead through
    std::vector<Polygons> obstacles = {};  ///< where nobody can stand, besides volumes
    std::vector<Polygons> flights = {};    ///< of steps, where nobody starts

    /// A rectangle with these half sides.
    void add_obstacle(const Point& at, const Point& u, const Point& v) {
        obstacles.push_back({Polygon{{at - u - v, at + u - v, at + u + v, at - u + v}, {}}});
    }
    void add_obstacle(const Point& at, double radius) {
        add_obstacle(at, Point(radius, 0), Point(0, radius));
    }
    void append(Built other) {
        const auto move = [](auto& from, auto& to) { std::ranges::move(from, std::back_inserter(to)); };
        move(other.solids, solids);
        move(other.openings, openings);
        move(other.obstacles, obstacles);
        move(other.flights, flights);
    }
};

/// "building-123"; of a relation "building-r123", of a node "building-n123".
std::string draft_id(const std::string& word, const ElementId& id);

}  // namespace campuswalk::scene::osm
