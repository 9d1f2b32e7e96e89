#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/osm/map.h"

namespace campuswalk::scene::osm {

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
/// The nearest point of a polyline and how far it is.
struct Nearest {
    Point at = Point::Zero();
    Point along = Point(1, 0);  ///< unit direction of its segment
    double distance = 1e300;
};
Nearest nearest_on(const std::vector<Point>& line, bool closed, const Point& p);

/// Triangles of polygons; indices into `points`, counter-clockwise.
struct Triangulation {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

enum class Caps { round, flat, square };

/// Overlays of GEOS. Coordinates come out as multiples of kGrid, which makes its overlays robust. The same
/// version of GEOS gives the same everywhere; triangles, buffers and rectangles may change with it. What has
/// no area is left out.
class PlanGeometry {
public:
    static constexpr double kGrid = 0.001;  ///< metres

    PlanGeometry();
    ~PlanGeometry();
    PlanGeometry(const PlanGeometry&) = delete;
    PlanGeometry& operator=(const PlanGeometry&) = delete;

    /// A valid polygon from a ring that may cross itself.
    Polygons polygon(const Ring& ring) const;
    /// The areas that lines enclose, those inside others being holes: a relation's members.
    Polygons areas_of_lines(const std::vector<std::vector<Point>>& lines) const;
    Polygons buffer(const std::vector<Point>& line, double radius, Caps caps) const;
    /// What is within a distance on the left of a line.
    Polygons left_side(const std::vector<Point>& line, double distance) const;
    Polygons grown(const Polygons& polygons, double by) const;
    Polygons clipped(const Polygons& polygons, const Box& box) const;
    /// Whether they touch or overlap.
    bool intersects(const Polygons& a, const Polygons& b) const;
    Polygons difference(const Polygons& a, const Polygons& b) const;
    Polygons intersection(const Polygons& a, const Polygons& b) const;
    Polygons united(const std::vector<const Polygons*>& all) const;
    Triangulation triangulated(const Polygon& polygon) const;
    /// How often GEOS failed: something is missing, or there twice.
    std::size_t failures() const;
    /// The least rectangle around a ring, counter-clockwise, its first edge the longer; empty if there is
    /// none. What is least depends on GEOS: to 3.11 the narrowest, whose width is the ring's least diameter.
    Ring least_rectangle(const Ring& ring) const;

private:
    void add_triangles(const Polygon& polygon, int depth, Triangulation& result) const;

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace campuswalk::scene::osm
