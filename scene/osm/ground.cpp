#include "scene/osm/ground.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/osm/box_index.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kTile = 64.0;  // metres; the cost of an overlay grows faster than its area
constexpr Look kEarth = {{132, 148, 104}, 245, 255};
constexpr Look kBed = {{112, 112, 96}, 240, 255};
constexpr Look kKerbstone = {{168, 166, 160}, 230, 255};

class Tiler {
public:
    Tiler(const std::vector<Surface>& surfaces, const PlanGeometry& geometry, const Terrain& terrain,
          ModelBuilder& model)
        : surfaces_(surfaces), geometry_(geometry), terrain_(terrain), model_(model), index_(kTile) {
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            if (!surfaces[i].area.empty()) {
                index_.add(i, box_of(surfaces[i].area));
            }
        }
    }

    void add_tile(const Box& tile) {
        std::vector<std::size_t> here = index_.near(tile);
        std::ranges::stable_sort(here, [&](std::size_t a, std::size_t b) {
            return surfaces_[a].priority > surfaces_[b].priority;
        });
        Polygons rest = {
            Polygon{{tile.min, {tile.max.x(), tile.min.y()}, tile.max, {tile.min.x(), tile.max.y()}}, {}}};
        std::map<double, std::vector<Polygons>> sunk;
        for (const std::size_t i : here) {
            const Surface& surface = surfaces_[i];
            const Polygons inside = geometry_.clipped(surface.area, tile);
            const Polygons piece = geometry_.intersection(inside, rest);
            if (piece.empty()) {
                continue;
            }
            rest = geometry_.difference(rest, inside);
            if (surface.hollow) {
                continue;
            }
            emit(piece, surface.water ? kBed : surface.look, surface.level, model_.object(surface.name));
            if (surface.water) {
                constexpr double kSurface = -0.2;
                emit(piece, surface.look, kSurface, model_.object("water-surface/" + surface.name));
            }
            if (surface.level < 0.0) {
                sunk[surface.level].push_back(piece);
            }
        }
        emit(rest, kEarth, 0.0, model_.object("ground"));
        for (const auto& [level, pieces] : sunk) {
            add_faces(pieces, level, tile);
        }
    }

private:
    void emit(const Polygons& area, const Look& look, double level, ObjectMesh& mesh) const {
        std::vector<std::array<Point, 3>> parts;
        for (const Polygon& polygon : area) {
            const Triangulation flat = geometry_.triangulated(polygon);
            for (const auto& [a, b, c] : flat.triangles) {
                parts.clear();
                terrain_.split({flat.points[a], flat.points[b], flat.points[c]}, parts);
                for (const std::array<Point, 3>& part : parts) {
                    mesh.triangle(look, on_ground(part[0], level), on_ground(part[1], level),
                                  on_ground(part[2], level));
                }
            }
        }
    }

    Point3 on_ground(const Point& p, double level) const { return {p, terrain_.height(p) + level}; }

    /// From the ground down to what lies below it, seen from inside.
    void add_faces(const std::vector<Polygons>& pieces, double level, const Box& tile) {
        std::vector<const Polygons*> all;
        for (const Polygons& piece : pieces) {
            all.push_back(&piece);
        }
        ObjectMesh& kerbs = model_.object("kerbs");
        const auto add = [&](const Ring& ring) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point& a = ring[i];
                const Point& b = ring[(i + 1) % ring.size()];
                if (!on_edge(a, b, tile)) {
                    add_face(a, b, level, kerbs);
                }
            }
        };
        for (const Polygon& polygon : geometry_.united(all)) {
            add(polygon.outer);
            for (const Ring& hole : polygon.holes) {
                add(hole);
            }
        }
    }

    void add_face(const Point& a, const Point& b, double level, ObjectMesh& mesh) const {
        const std::vector<Point> points = terrain_.split(a, b);
        for (std::size_t i = 1; i < points.size(); ++i) {
            mesh.quad(kKerbstone, on_ground(points[i], level), on_ground(points[i - 1], level),
                      on_ground(points[i - 1], 0.0), on_ground(points[i], 0.0));
        }
    }

    static bool on_edge(const Point& a, const Point& b, const Box& tile) {
        return (a.x() == b.x() && (a.x() == tile.min.x() || a.x() == tile.max.x())) ||
               (a.y() == b.y() && (a.y() == tile.min.y() || a.y() == tile.max.y()));
    }

    const std::vector<Surface>& surfaces_;
    const PlanGeometry& geometry_;
    const Terrain& terrain_;
    ModelBuilder& model_;
    BoxIndex index_;
};

}  // namespace

void add_ground(const std::vector<Surface>& surfaces, const Box& box, const PlanGeometry& geometry,
                const Terrain& terrain, ModelBuilder& model) {
    model.object("ground");
    Tiler tiler(surfaces, geometry, terrain, model);
    const auto tile_of = [](double value) { return static_cast<int>(std::floor(value / kTile)); };
    for (int row = tile_of(box.min.y()); row * kTile < box.max.y(); ++row) {
        for (int column = tile_of(box.min.x()); column * kTile < box.max.x(); ++column) {
            const Box tile{
                {std::max(column * kTile, box.min.x()), std::max(row * kTile, box.min.y())},
                {std::min((column + 1) * kTile, box.max.x()), std::min((row + 1) * kTile, box.max.y())}};
            if (tile.size().minCoeff() > 0.0) {
                tiler.add_tile(tile);
            }
        }
    }
}

}  // namespace campuswalk::scene::osm
