#pragma once

#include <utility>
#include <vector>

#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

/// A line of the plan: the points with `normal · p = offset`.
struct PlanLine {
    Point normal = Point(1, 0);
    double offset = 0.0;

    double side(const Point& p) const { return normal.x() * p.x() + normal.y() * p.y() - offset; }
};

/// A convex polygon, counter-clockwise.
using Convex = std::vector<Point>;

/// Where a segment crosses a line that its ends are on either side of; the same from both ends.
Point crossing(const PlanLine& line, const Point& a, const Point& b);

/// The parts of a convex polygon below and above a line; fewer than three points if there is none.
std::pair<Convex, Convex> cut(const Convex& polygon, const PlanLine& line);

/// The parts into which several lines cut it.
std::vector<Convex> cut_all(Convex polygon, const std::vector<PlanLine>& lines);

/// The ends of a segment, and where lines cross it, in order.
std::vector<Point> cut_segment(const Point& a, const Point& b, const std::vector<PlanLine>& lines);

}  // namespace campuswalk::scene::osm
