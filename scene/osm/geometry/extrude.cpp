#include "scene/osm/geometry/extrude.h"

namespace campuswalk::scene::osm {

void extrude(const Look& look, const Polygons& area, double below, double above, const PlanGeometry& geometry,
             const Terrain& terrain, ObjectMesh& mesh) {
    const auto high = [&](const Point& p) { return Point3{p, terrain.height(p) + above}; };
    const auto low = [&](const Point& p) { return Point3{p, terrain.height(p) - below}; };
    const auto add_walls = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::vector<Point> points = terrain.split(ring[i], ring[(i + 1) % ring.size()]);
            for (std::size_t k = 1; k < points.size(); ++k) {
                mesh.quad(look, low(points[k - 1]), low(points[k]), high(points[k]), high(points[k - 1]));
            }
        }
    };
    std::vector<std::array<Point, 3>> parts;
    for (const Polygon& polygon : area) {
        add_walls(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            add_walls(hole);
        }
        const Triangulation flat = geometry.triangulated(polygon);
        for (const auto& [a, b, c] : flat.triangles) {
            terrain.split({flat.points[a], flat.points[b], flat.points[c]}, parts);
        }
    }
    for (const std::array<Point, 3>& part : parts) {
        mesh.triangle(look, high(part[0]), high(part[1]), high(part[2]));
    }
}

}  // namespace campuswalk::scene::osm
