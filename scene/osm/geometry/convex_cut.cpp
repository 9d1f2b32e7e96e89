#include "scene/osm/geometry/convex_cut.h"

#include <algorithm>

namespace campuswalk::scene::osm {

Point crossing(const PlanLine& line, const Point& a, const Point& b) {
    const bool ordered = a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    const Point& from = ordered ? a : b;
    const Point& to = ordered ? b : a;
    const double side_from = line.side(from);
    const double t = side_from / (side_from - line.side(to));
    return from + t * (to - from);
}

std::pair<Convex, Convex> cut(const Convex& polygon, const PlanLine& line) {
    std::pair<Convex, Convex> parts;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        const double side_a = line.side(a);
        const double side_b = line.side(b);
        if (side_a <= 0.0) {
            parts.first.push_back(a);
        }
        if (side_a >= 0.0) {
            parts.second.push_back(a);
        }
        if ((side_a < 0.0 && side_b > 0.0) || (side_a > 0.0 && side_b < 0.0)) {
            const Point p = crossing(line, a, b);
            parts.first.push_back(p);
            parts.second.push_back(p);
        }
    }
    return parts;
}

std::vector<Convex> cut_all(Convex polygon, const std::vector<PlanLine>& lines) {
    std::vector<Convex> pieces = {std::move(polygon)};
    for (const PlanLine& line : lines) {
        std::vector<Convex> done;
        for (const Convex& piece : pieces) {
            auto [below, above] = cut(piece, line);
            for (Convex* part : {&below, &above}) {
                if (part->size() >= 3) {
                    done.push_back(std::move(*part));
                }
            }
        }
        pieces = std::move(done);
    }
    return pieces;
}

std::vector<Point> cut_segment(const Point& a, const Point& b, const std::vector<PlanLine>& lines) {
    std::vector<Point> points = {a, b};
    for (const PlanLine& line : lines) {
        const double side_a = line.side(a);
        const double side_b = line.side(b);
        if ((side_a < 0.0 && side_b > 0.0) || (side_a > 0.0 && side_b < 0.0)) {
            points.push_back(crossing(line, a, b));
        }
    }
    const Point d = b - a;
    std::ranges::sort(points, {}, [&](const Point& p) { return (p - a).x() * d.x() + (p - a).y() * d.y(); });
    return points;
}

}  // namespace campuswalk::scene::osm
