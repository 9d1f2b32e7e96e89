#include "scene/osm/ways/ground_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campuswalk::scene::osm {
namespace {

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

}  // namespace

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

}  // namespace campuswalk::scene::osm
