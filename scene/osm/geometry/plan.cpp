#include "scene/osm/geometry/plan.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::scene::osm {

double norm(const Point& v) {
    return std::sqrt(v.x() * v.x() + v.y() * v.y());
}

Point unit(const Point& direction) {
    const double length = norm(direction);
    return length > 0.0 ? Point(direction / length) : Point(1, 0);
}

double signed_area(const Ring& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i] - ring[0];
        const Point b = ring[(i + 1) % ring.size()] - ring[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

double area_of(const Polygons& polygons) {
    double area = 0.0;
    for (const Polygon& polygon : polygons) {
        area += signed_area(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            area += signed_area(hole);
        }
    }
    return area;
}

Box box_of(const Polygons& polygons) {
    Box box = box_of(polygons.front().outer);
    for (const Polygon& polygon : polygons) {
        for (const Point& p : polygon.outer) {
            box.extend(p);
        }
    }
    return box;
}

namespace {

bool ring_contains(const Ring& ring, const Point& p) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point& a = ring[i];
        const Point& b = ring[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
            inside = !inside;
        }
    }
    return inside;
}

}  // namespace

bool contains(const Polygon& polygon, const Point& p) {
    return ring_contains(polygon.outer, p) &&
           std::ranges::none_of(polygon.holes, [&](const Ring& hole) { return ring_contains(hole, p); });
}

bool contains(const Polygons& polygons, const Point& p) {
    return std::ranges::any_of(polygons, [&](const Polygon& polygon) { return contains(polygon, p); });
}

double length_inside(const std::vector<Point>& line, const Polygons& polygons) {
    constexpr double kSample = 0.25;
    const Box box = box_of(polygons);
    double inside = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        if (!box_of({line[i - 1], line[i]}).overlaps(box)) {
            continue;
        }
        const double length = norm(d);
        const int samples = std::min(4'000, static_cast<int>(length / kSample) + 1);
        for (int k = 0; k < samples; ++k) {
            const Point p = line[i - 1] + d * ((k + 0.5) / samples);
            inside += contains(polygons, p) ? length / samples : 0.0;
        }
    }
    return inside;
}

Nearest nearest_on(const std::vector<Point>& line, bool closed, const Point& p) {
    Nearest nearest;
    const std::size_t segments = closed ? line.size() : line.size() - 1;
    for (std::size_t i = 0; i < segments; ++i) {
        const Point& a = line[i];
        const Point d = line[(i + 1) % line.size()] - a;
        const double length2 = d.x() * d.x() + d.y() * d.y();
        if (length2 <= 0.0) {
            continue;
        }
        const Point from = p - a;
        const double t = std::clamp((from.x() * d.x() + from.y() * d.y()) / length2, 0.0, 1.0);
        const Point at = a + t * d;
        const Point off = p - at;
        const double distance = norm(off);
        if (distance < nearest.distance) {
            nearest = {at, d / std::sqrt(length2), distance};
        }
    }
    return nearest;
}

Nearest nearest_on(const Polygon& polygon, const Point& p) {
    Nearest nearest = nearest_on(polygon.outer, true, p);
    for (const Ring& hole : polygon.holes) {
        const Nearest other = nearest_on(hole, true, p);
        nearest = other.distance < nearest.distance ? other : nearest;
    }
    return nearest;
}

Nearest nearest_on(const Polygons& polygons, const Point& p) {
    Nearest nearest;
    for (const Polygon& polygon : polygons) {
        const Nearest other = nearest_on(polygon, p);
        nearest = other.distance < nearest.distance ? other : nearest;
    }
    return nearest;
}

}  // namespace campuswalk::scene::osm
