#include "scene/osm/ways/ground.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scene/osm/geometry/box_index.h"

namespace campuswalk::scene::osm {

namespace {

/// The part of a surface in a tile of the ground.
struct GroundPiece {
    const Surface* surface = nullptr;
    Polygons area;
};

constexpr Look kKerbstone = {{168, 166, 160}, 230, 255};

bool is_on_edge(const Point& a, const Point& b, const Box& tile) {
    return (a.x() == b.x() && (a.x() == tile.min.x() || a.x() == tile.max.x())) ||
           (a.y() == b.y() && (a.y() == tile.min.y() || a.y() == tile.max.y()));
}

class Faces {
public:
    Faces(const std::vector<GroundPiece>& pieces, const Box& tile, const Terrain& terrain, ObjectMesh& mesh)
        : pieces_(pieces), tile_(tile), terrain_(terrain), mesh_(mesh) {
        for (const GroundPiece& piece : pieces) {
            boxes_.push_back(box_of(piece.area));
            for (const Polygon& polygon : piece.area) {
                vertices_.insert(vertices_.end(), polygon.outer.begin(), polygon.outer.end());
                for (const Ring& hole : polygon.holes) {
                    vertices_.insert(vertices_.end(), hole.begin(), hole.end());
                }
            }
        }
        std::ranges::sort(vertices_, [](const Point& a, const Point& b) {
            return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
        });
        vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    }

    void add(const GroundPiece& piece) {
        for (const Polygon& polygon : piece.area) {
            add_ring(piece, polygon.outer);
            for (const Ring& hole : polygon.holes) {
                add_ring(piece, hole);
            }
        }
    }

private:
    void add_ring(const GroundPiece& piece, const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point& a = ring[i];
            const Point& b = ring[(i + 1) % ring.size()];
            if (is_on_edge(a, b, tile_)) {
                continue;
            }
            const std::vector<Point> points = with_vertices_between(a, b);
            for (std::size_t k = 1; k < points.size(); ++k) {
                add_edge(piece, points[k - 1], points[k]);
            }
        }
    }

    /// The ends of an edge and the vertices of other pieces on it.
    std::vector<Point> with_vertices_between(const Point& a, const Point& b) const {
        constexpr double kOn = 0.0015;  // metres: a little more than the grid of the overlays
        std::vector<Point> points = {a, b};
        const Box near = box_of(points).grown(kOn);
        const Point d = b - a;
        const double length = norm(d);
        const auto first =
            std::ranges::lower_bound(vertices_, near.min.x(), {}, [](const Point& p) { return p.x(); });
        for (auto p = first; p != vertices_.end() && p->x() <= near.max.x(); ++p) {
            const Point from = *p - a;
            const double along = (from.x() * d.x() + from.y() * d.y()) / length;
            const double off = std::abs(from.x() * d.y() - from.y() * d.x()) / length;
            if (near.contains(*p) && off < kOn && along > kOn && along < length - kOn) {
                points.push_back(*p);
            }
        }
        std::ranges::sort(points, {}, [&](const Point& p) { return (p - a).dot(d); });
        return points;
    }

    /// What is beside an edge on its right; null for the ground.
    const Surface* beside(const Point& a, const Point& b) const {
        constexpr double kProbe = 0.004;  // metres
        const Point right(unit(b - a).y(), -unit(b - a).x());
        const Point p = 0.5 * (a + b) + kProbe * right;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (boxes_[i].contains(p) && contains(pieces_[i].area, p)) {
                return pieces_[i].surface;
            }
        }
        return nullptr;
    }

    void add_edge(const GroundPiece& piece, const Point& a, const Point& b) {
        constexpr double kLeast = 0.001;  // metres
        const Surface* other = beside(a, b);
        const Surface& own = *piece.surface;
        const auto upper = [&](const Point& p) {
            return std::max(own.level_at(p), other == nullptr ? 0.0 : other->level_at(p));
        };
        if (upper(a) - own.level_at(a) < kLeast && upper(b) - own.level_at(b) < kLeast) {
            return;
        }
        const std::vector<Point> points = terrain_.split(a, b);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point& p = points[i - 1];
            const Point& q = points[i];
            const double hp = terrain_.height(p);
            const double hq = terrain_.height(q);
            mesh_.quad(kKerbstone, {q, hq + own.level_at(q)}, {p, hp + own.level_at(p)}, {p, hp + upper(p)},
                       {q, hq + upper(q)});
        }
    }

    const std::vector<GroundPiece>& pieces_;
    const Box& tile_;
    const Terrain& terrain_;
    ObjectMesh& mesh_;
    std::vector<Box> boxes_;
    std::vector<Point> vertices_;
};

/// Upright faces, the node `kerbs`, from the edges of pieces that lie lower up to what is beside them; what
/// isn't in a piece is at 0. The tile's own edges have none.
void add_faces(const std::vector<GroundPiece>& pieces, const Box& tile, const Terrain& terrain,
               ModelBuilder& model) {
    if (std::ranges::none_of(pieces, [](const GroundPiece& piece) {
            return piece.surface->level < 0.0 || piece.surface->fall.has_value();
        })) {
        return;
    }
    Faces faces(pieces, tile, terrain, model.object("kerbs"));
    for (const GroundPiece& piece : pieces) {
        if (piece.surface->level < 0.0 || piece.surface->fall) {
            faces.add(piece);
        }
    }
}

constexpr double kTile = 64.0;  // metres; the cost of an overlay grows faster than its area
constexpr Look kEarth = {{132, 148, 104}, 245, 255};
constexpr Look kBed = {{112, 112, 96}, 240, 255};

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
        std::vector<std::size_t> here = surfaces_at(tile);
        std::ranges::stable_sort(here, [&](std::size_t a, std::size_t b) {
            return surfaces_[a].priority > surfaces_[b].priority;
        });
        Polygons rest = {
            Polygon{{tile.min, {tile.max.x(), tile.min.y()}, tile.max, {tile.min.x(), tile.max.y()}}, {}}};
        std::vector<GroundPiece> pieces;
        for (const std::size_t i : here) {
            if (rest.empty()) {
                break;
            }
            const Surface& surface = surfaces_[i];
            geometry_.charge_to(surface.name);
            if (!geometry_.intersects(surface.area, rest)) {
                continue;  // far cheaper than an overlay
            }
            const Polygons inside = geometry_.clipped(surface.area, tile);
            Polygons piece = geometry_.intersection(inside, rest);
            if (piece.empty()) {
                continue;
            }
            rest = geometry_.difference(rest, inside);
            if (surface.hollow) {
                continue;
            }
            emit(piece, surface.water ? kBed : surface.look, surface, model_.object(surface.name));
            if (surface.water) {
                constexpr double kSurface = -0.2;
                emit(piece, surface.look, Surface{"", {}, {}, 0, kSurface},
                     model_.object("water-surface/" + surface.name));
            }
            pieces.push_back({&surface, std::move(piece)});
        }
        geometry_.charge_to("ground");
        emit(rest, kEarth, {}, model_.object("ground"));
        add_faces(pieces, tile, terrain_, model_);
    }

private:
    /// A square of the grid with this edge, which is tiled by four by four of the next smaller one.
    struct Block {
        double edge = 0.0;
        int row = 0;
        int column = 0;
        friend auto operator<=>(const Block&, const Block&) = default;
    };

    static Block block_at(const Point& p, double edge) {
        return {edge, static_cast<int>(std::floor(p.y() / edge)), static_cast<int>(std::floor(p.x() / edge))};
    }

    /// Those that may overlap the tile: of long paths, whose boxes cover much, only those that come near.
    std::vector<std::size_t> surfaces_at(const Box& tile) {
        std::vector<std::size_t> here;
        for (const std::size_t i : surfaces_in(block_at(0.5 * (tile.min + tile.max), 4.0 * kTile))) {
            if (box_of(surfaces_[i].area).overlaps(tile)) {
                here.push_back(i);
            }
        }
        return here;
    }

    const std::vector<std::size_t>& surfaces_in(const Block& block) {
        const auto [known, is_new] = in_block_.try_emplace(block);
        if (!is_new) {
            return known->second;
        }
        const Point least(block.column * block.edge, block.row * block.edge);
        const Box box{least, least + Point(block.edge, block.edge)};
        const Polygons square = {
            Polygon{{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}, {}}};
        constexpr double kLargest = 16.0 * kTile;
        const std::vector<std::size_t> candidates =
            block.edge < kLargest ? surfaces_in(block_at(0.5 * (box.min + box.max), 4.0 * block.edge))
                                  : index_.near(box);
        std::vector<std::size_t> found;
        for (const std::size_t i : candidates) {
            const Box extent = box_of(surfaces_[i].area);
            geometry_.charge_to(surfaces_[i].name);
            const bool small = extent.size().maxCoeff() < block.edge;
            if (extent.overlaps(box) && (small || geometry_.intersects(surfaces_[i].area, square))) {
                found.push_back(i);
            }
        }
        return in_block_[block] = std::move(found);  // the map may have grown meanwhile
    }

    void emit(const Polygons& area, const Look& look, const Surface& surface, ObjectMesh& mesh) const {
        std::vector<std::array<Point, 3>> parts;
        for (const Polygon& polygon : area) {
            const Triangulation flat = geometry_.triangulated(polygon);
            for (const auto& [a, b, c] : flat.triangles) {
                parts.clear();
                terrain_.split({flat.points[a], flat.points[b], flat.points[c]}, parts);
                for (const std::array<Point, 3>& part : parts) {
                    mesh.triangle(look, on_ground(part[0], surface), on_ground(part[1], surface),
                                  on_ground(part[2], surface));
                }
            }
        }
    }

    Point3 on_ground(const Point& p, const Surface& surface) const {
        return {p, terrain_.height(p) + surface.level_at(p)};
    }

    const std::vector<Surface>& surfaces_;
    const PlanGeometry& geometry_;
    const Terrain& terrain_;
    ModelBuilder& model_;
    BoxIndex index_;
    std::map<Block, std::vector<std::size_t>> in_block_;
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
