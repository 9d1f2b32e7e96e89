#pragma once

#include <vector>

#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

// Lines and polygons of the plan, and what can be said of them without overlays.

/// Without the repeated last point; counter-clockwise if it is an outer ring, clockwise if a hole.
using Ring = std::vector<Point>;

struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
};
using Polygons = std::vector<Polygon>;

/// A quarter turn to the left.
inline Point left_of(const Point& direction) {
    return {-direction.y(), direction.x()};
}
/// The length of a vector.
double norm(const Point& v);
/// The same direction with length 1; east for no direction.
Point unit(const Point& direction);

double signed_area(const Ring& ring);
double area_of(const Polygons& polygons);
/// Of the outer rings; not for none.
Box box_of(const Polygons& polygons);
bool contains(const Polygon& polygon, const Point& p);
bool contains(const Polygons& polygons, const Point& p);
/// How much of a polyline is inside of polygons, metres; sampled. Polygons: at least one.
double length_inside(const std::vector<Point>& line, const Polygons& polygons);
/// The nearest point of a polyline and how far it is.
struct Nearest {
    Point at = Point::Zero();
    Point along = Point(1, 0);  ///< unit direction of its segment
    double distance = 1e300;
};
Nearest nearest_on(const std::vector<Point>& line, bool closed, const Point& p);
/// Of its outer ring and its holes.
Nearest nearest_on(const Polygon& polygon, const Point& p);
Nearest nearest_on(const Polygons& polygons, const Point& p);

}  // namespace campuswalk::scene::osm
