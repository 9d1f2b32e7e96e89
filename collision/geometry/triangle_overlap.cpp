#include "collision/geometry/triangle_overlap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "collision/geometry/orientation.h"
#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

namespace {

using Vec2 = Eigen::Vector2d;
using Vertices = std::array<Vec3, 3>;
using FlatVertices = std::array<Vec2, 3>;

/// The side of a plane that each vertex of a triangle lies on: -1, 0 or 1.
using Sides = std::array<int, 3>;

/// The sides of t's plane that s's vertices lie on; all 0 if t has no area.
Sides sides_of_plane(const Vertices& t, const Vertices& s) {
    const auto side = [&](const Vec3& p) { return orientation(t[0], t[1], t[2], p); };
    return {side(s[0]), side(s[1]), side(s[2])};
}

bool all_on_one_side(const Sides& sides) {
    return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

bool all_on_plane(const Sides& sides) {
    return sides == Sides{0, 0, 0};
}

// Two triangles with area, in planes that intersect.

/// Rotates the vertices so that both edges at the first one cross the plane or end on it, and neither lies in
/// it. Returns the first vertex's side; if that is on the plane, the side that the others aren't on.
int put_lone_vertex_first(Vertices& s, const Sides& sides) {
    const auto is_lone = [&](std::size_t i) {
        const int side = sides[i];
        const int next = sides[(i + 1) % 3];
        const int last = sides[(i + 2) % 3];
        return side != 0 ? side * next <= 0 && side * last <= 0 : next == last;
    };
    const std::size_t lone = is_lone(0) ? 0 : is_lone(1) ? 1 : 2;
    s = {s[lone], s[(lone + 1) % 3], s[(lone + 2) % 3]};
    return sides[lone] != 0 ? sides[lone] : -sides[(lone + 1) % 3];
}

/// Each triangle intersects the line that the planes share in an interval, between the edges at its lone
/// vertex. Once both lone vertices are where orientation() is 1, s' first edge crosses the line after its
/// last, t's before its last, in the same direction. The intervals overlap unless s' first crossing is before
/// t's first, or s' last after t's last; the orientation of the two edges' vertices tells which of two comes
/// first.
bool intervals_overlap(Vertices s, Vertices t, const Sides& sides_s, const Sides& sides_t) {
    const int side_s = put_lone_vertex_first(s, sides_s);
    const int side_t = put_lone_vertex_first(t, sides_t);
    if (side_s < 0) {
        std::swap(t[1], t[2]);
    }
    if (side_t < 0) {
        std::swap(s[1], s[2]);
    }
    return orientation(s[0], s[1], t[0], t[1]) <= 0 && orientation(s[0], s[2], t[0], t[2]) >= 0;
}

// A triangle without area, and one with area whose plane it crosses.

/// A triangle without area as a segment: points on a line are ordered like their coordinates.
Segment segment_of(const Vertices& s) {
    const auto before = [](const Vec3& p, const Vec3& q) {
        return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    };
    const auto [first, last] = std::minmax_element(s.begin(), s.end(), before);
    return {*first, *last};
}

/// Whether the line has all edges on the same side, or passes through some.
bool line_intersects(const Segment& e, const Vertices& t) {
    const auto side = [&](std::size_t i) { return orientation(e.a, e.b, t[i], t[(i + 1) % 3]); };
    const Sides sides = {side(0), side(1), side(2)};
    const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
    return *least * *greatest >= 0;
}

// Triangles in one plane, at least one with area: seen along an axis that isn't in the plane.

Vec2 along(std::size_t axis, const Vec3& p) {
    constexpr std::array<std::array<int, 2>, 3> kOtherAxes = {{{1, 2}, {2, 0}, {0, 1}}};
    return {p[kOtherAxes[axis][0]], p[kOtherAxes[axis][1]]};
}

FlatVertices along(std::size_t axis, const Vertices& t) {
    return {along(axis, t[0]), along(axis, t[1]), along(axis, t[2])};
}

int turn(const FlatVertices& t) {
    return orientation(t[0], t[1], t[2]);
}

/// Whether all of t is beyond an edge of s. A triangle without area has no inside: both its sides are beyond.
bool beyond_an_edge(const FlatVertices& s, int turn_of_s, const FlatVertices& t) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto side = [&](const Vec2& p) { return orientation(s[i], s[(i + 1) % 3], p); };
        const int first = side(t[0]);
        if (first != 0 && first != turn_of_s && side(t[1]) == first && side(t[2]) == first) {
            return true;
        }
    }
    return false;
}

/// Convex sets are apart if 0 lies outside their difference {p - q}. Here that is a polygon with area, whose
/// edges are parallel to edges of s or t.
bool overlap_in_plane(const FlatVertices& s, int turn_of_s, const FlatVertices& t, int turn_of_t) {
    return !beyond_an_edge(s, turn_of_s, t) && !beyond_an_edge(t, turn_of_t, s);
}

// Segments, which may be points.

/// Whether, seen along an axis, neither segment lies entirely on one side of the other's line.
bool straddle(const Segment& e, const Segment& f, std::size_t axis) {
    const Vec2 ea = along(axis, e.a);
    const Vec2 eb = along(axis, e.b);
    const Vec2 fa = along(axis, f.a);
    const Vec2 fb = along(axis, f.b);
    return orientation(ea, eb, fa) * orientation(ea, eb, fb) <= 0 &&
           orientation(fa, fb, ea) * orientation(fa, fb, eb) <= 0;
}

/// If the four points span a plane, it is a plane in at least one of the views, and there segments that
/// straddle each other and whose boxes overlap do intersect. If they span a line, the boxes alone decide. The
/// other views never refuse segments that intersect.
bool segments_intersect(const Segment& e, const Segment& f) {
    const bool boxes_overlap = (e.a.cwiseMin(e.b).array() <= f.a.cwiseMax(f.b).array()).all() &&
                               (f.a.cwiseMin(f.b).array() <= e.a.cwiseMax(e.b).array()).all();
    return boxes_overlap && orientation(e.a, e.b, f.a, f.b) == 0 && straddle(e, f, 0) && straddle(e, f, 1) &&
           straddle(e, f, 2);
}

/// For two triangles without area, or both in one plane.
bool overlap_flat(const Vertices& s, const Vertices& t) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const FlatVertices flat_s = along(axis, s);
        const FlatVertices flat_t = along(axis, t);
        const int turn_of_s = turn(flat_s);
        const int turn_of_t = turn(flat_t);
        if (turn_of_s != 0 || turn_of_t != 0) {
            return overlap_in_plane(flat_s, turn_of_s, flat_t, turn_of_t);
        }
    }
    return segments_intersect(segment_of(s), segment_of(t));
}

}  // namespace

bool overlap(const Triangle& first, const Triangle& second) {
    const Vertices s = {first.a, first.b, first.c};
    const Vertices t = {second.a, second.b, second.c};
    const Sides sides_s = sides_of_plane(t, s);
    if (all_on_one_side(sides_s)) {
        return false;
    }
    const Sides sides_t = sides_of_plane(s, t);
    if (all_on_one_side(sides_t)) {
        return false;
    }
    // sides_s is all 0 if t has no area, or if s lies in its plane: then sides_t is all 0 too.
    if (all_on_plane(sides_s)) {
        return all_on_plane(sides_t) ? overlap_flat(s, t) : line_intersects(segment_of(t), s);
    }
    return all_on_plane(sides_t) ? line_intersects(segment_of(s), t)
                                 : intervals_overlap(s, t, sides_s, sides_t);
}

}  // namespace campuswalk::collision
