#include "scene/osm/geometry/plan_geometry.h"

#include <algorithm>
#include <cmath>

#include "scene/osm/geometry/geos_context.h"

namespace campuswalk::scene::osm {

namespace {

constexpr std::size_t kPieceOfLine = 128;  // points
/// Crossings of a ring with itself. What it goes around an odd number of times would take GEOS seconds to
/// find from a thousand on, and minutes from some thousands.
constexpr std::size_t kScrawl = 100;

std::size_t vertices_of(const Polygons& polygons) {
    std::size_t count = 0;
    for (const Polygon& polygon : polygons) {
        count += polygon.outer.size();
        for (const Ring& hole : polygon.holes) {
            count += hole.size();
        }
    }
    return count;
}

}  // namespace

PlanGeometry::PlanGeometry(const OverlayBudget& budget)
    : geos_(std::make_unique<GeosContext>(kGrid, budget)) {}
PlanGeometry::~PlanGeometry() = default;

Polygons PlanGeometry::polygon(const Ring& ring) const {
    if (ring.size() < 3) {
        return {};
    }
    const GeosContext::Geometry raw = geos_->geometry(Polygon{ring, {}});
    if (!raw) {
        return {};
    }
    if (GEOSisValid_r(geos_->handle(), raw.get()) == 1) {
        geos_->budget().spend(ring.size());
        return geos_->polygons_of(raw);
    }
    const Polygons drawn = {Polygon{ring, {}}};
    if (geos_->spend_on_areas({&drawn}) > kScrawl) {
        return {};
    }
    return geos_->rounded(geos_->own(GEOSMakeValid_r(geos_->handle(), raw.get())));
}

Polygons PlanGeometry::areas_of_lines(const std::vector<std::vector<Point>>& lines) const {
    std::vector<Segment> segments;
    for (const std::vector<Point>& line : lines) {
        append_segments(line, segments);
    }
    geos_->budget().spend(segments);
    const GeosContext::Geometry all = geos_->lines(lines);
    if (!all) {
        return {};
    }
    const GeosContext::Geometry noded = geos_->own(GEOSNode_r(geos_->handle(), all.get()));
    return noded ? geos_->rounded(geos_->own(GEOSBuildArea_r(geos_->handle(), noded.get()))) : Polygons();
}

Polygons PlanGeometry::buffer(const std::vector<Point>& line, double radius, Caps caps) const {
    constexpr int kQuarterSegments = 4;
    constexpr double kMitreLimit = 2.0;
    const int cap = caps == Caps::round  ? GEOSBUF_CAP_ROUND
                    : caps == Caps::flat ? GEOSBUF_CAP_FLAT
                                         : GEOSBUF_CAP_SQUARE;
    if (line.size() < 2) {
        return {};
    }
    geos_->spend_on_line(line);
    if (line.size() > kPieceOfLine && caps != Caps::square) {
        return buffer_in_pieces(line, radius, caps);
    }
    const GeosContext::Geometry path = geos_->line(line);
    return geos_->rounded(geos_->own(
        GEOSBufferWithStyle_r(geos_->handle(), path.get(), radius, kQuarterSegments, cap,
                              caps == Caps::round ? GEOSBUF_JOIN_ROUND : GEOSBUF_JOIN_MITRE, kMitreLimit)));
}

/// A buffer takes time with the square of its line's length where that crosses itself. Pieces share two
/// segments, so that each bend is inside one of them.
Polygons PlanGeometry::buffer_in_pieces(const std::vector<Point>& line, double radius, Caps caps) const {
    constexpr std::size_t kShared = 2;
    std::vector<Polygons> pieces;
    for (std::size_t first = 0; first + kShared + 1 < line.size(); first += kPieceOfLine - 1 - kShared) {
        const auto begin = line.begin() + static_cast<std::ptrdiff_t>(first);
        const auto length = static_cast<std::ptrdiff_t>(std::min(kPieceOfLine, line.size() - first));
        pieces.push_back(buffer(std::vector<Point>(begin, begin + length), radius, caps));
    }
    std::vector<const Polygons*> all;
    all.reserve(pieces.size());
    for (const Polygons& piece : pieces) {
        all.push_back(&piece);
    }
    return united(all);
}

Polygons PlanGeometry::left_side(const std::vector<Point>& line, double distance) const {
    constexpr double kMitreLimit = 2.0;
    if (line.size() < 2) {
        return {};
    }
    geos_->spend_on_line(line);
    const GeosContext::Geometry path = geos_->line(line);
    GEOSBufferParams* params = GEOSBufferParams_create_r(geos_->handle());
    GEOSBufferParams_setSingleSided_r(geos_->handle(), params, 1);
    GEOSBufferParams_setJoinStyle_r(geos_->handle(), params, GEOSBUF_JOIN_MITRE);
    GEOSBufferParams_setMitreLimit_r(geos_->handle(), params, kMitreLimit);
    const GeosContext::Geometry side =
        geos_->own(GEOSBufferWithParams_r(geos_->handle(), path.get(), params, distance));
    GEOSBufferParams_destroy_r(geos_->handle(), params);
    return geos_->rounded(side);
}

Polygons PlanGeometry::grown(const Polygons& polygons, double by) const {
    constexpr int kQuarterSegments = 4;
    constexpr double kMitreLimit = 2.0;
    if (polygons.empty()) {
        return {};
    }
    geos_->spend_on_areas({&polygons});
    const GeosContext::Geometry area = geos_->geometry(polygons);
    return geos_->rounded(
        geos_->own(GEOSBufferWithStyle_r(geos_->handle(), area.get(), by, kQuarterSegments, GEOSBUF_CAP_FLAT,
                                         GEOSBUF_JOIN_MITRE, kMitreLimit)));
}

Polygons PlanGeometry::clipped(const Polygons& polygons, const Box& box) const {
    if (polygons.empty()) {
        return {};
    }
    const Box inside = box_of(polygons);
    if (box.contains(inside.min) && box.contains(inside.max)) {
        return polygons;
    }
    return intersection(
        polygons, {Polygon{{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}, {}}});
}

bool PlanGeometry::intersects(const Polygons& a, const Polygons& b) const {
    if (a.empty() || b.empty() || !box_of(a).overlaps(box_of(b))) {
        return false;
    }
    geos_->budget().spend(vertices_of(a) + vertices_of(b));
    const GeosContext::Geometry first = geos_->geometry(a);
    const GeosContext::Geometry second = geos_->geometry(b);
    return GEOSIntersects_r(geos_->handle(), first.get(), second.get()) != 0;  // or it failed
}

Polygons PlanGeometry::difference(const Polygons& a, const Polygons& b) const {
    if (a.empty() || b.empty() || !box_of(a).overlaps(box_of(b))) {
        return a;
    }
    geos_->spend_on_areas({&a, &b});
    const GeosContext::Geometry from = geos_->geometry(a);
    const GeosContext::Geometry cut = geos_->geometry(b);
    const GeosContext::Geometry rest =
        geos_->own(GEOSDifferencePrec_r(geos_->handle(), from.get(), cut.get(), kGrid));
    Polygons polygons = geos_->polygons_of(rest);
    return rest ? polygons : a;  // rather twice than not at all
}

Polygons PlanGeometry::intersection(const Polygons& a, const Polygons& b) const {
    if (a.empty() || b.empty() || !box_of(a).overlaps(box_of(b))) {
        return {};
    }
    geos_->spend_on_areas({&a, &b});
    const GeosContext::Geometry first = geos_->geometry(a);
    const GeosContext::Geometry second = geos_->geometry(b);
    return geos_->polygons_of(
        geos_->own(GEOSIntersectionPrec_r(geos_->handle(), first.get(), second.get(), kGrid)));
}

Polygons PlanGeometry::symmetric_difference(const Polygons& a, const Polygons& b) const {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    geos_->spend_on_areas({&a, &b});
    const GeosContext::Geometry first = geos_->geometry(a);
    const GeosContext::Geometry second = geos_->geometry(b);
    return geos_->polygons_of(
        geos_->own(GEOSSymDifferencePrec_r(geos_->handle(), first.get(), second.get(), kGrid)));
}

Polygons PlanGeometry::united(const std::vector<const Polygons*>& all) const {
    geos_->spend_on_union(all);
    const GeosContext::Geometry collection = geos_->collection(all);
    return geos_->polygons_of(geos_->own(GEOSUnaryUnionPrec_r(geos_->handle(), collection.get(), kGrid)));
}

namespace {

/// Triangles of what GEOS can triangulate; of the rest their area is missing.
Triangulation triangles_of(const Polygon& polygon, const GeosContext& geos) {
    geos.budget().spend_on_triangles(vertices_of({polygon}));
    Triangulation result;
    const GeosContext::Geometry area = geos.geometry(polygon);
    const GeosContext::Geometry triangles =
        area ? geos.own(GEOSConstrainedDelaunayTriangulation_r(geos.handle(), area.get())) : nullptr;
    const int count = triangles ? GEOSGetNumGeometries_r(geos.handle(), triangles.get()) : 0;
    for (int i = 0; i < count; ++i) {
        const GEOSGeometry* triangle = GEOSGetGeometryN_r(geos.handle(), triangles.get(), i);
        const Ring ring = geos.ring_of(GEOSGetExteriorRing_r(geos.handle(), triangle), true);
        if (ring.size() != 3 || signed_area(ring) <= 0.0) {
            continue;
        }
        const auto first = static_cast<std::uint32_t>(result.points.size());
        result.points.insert(result.points.end(), ring.begin(), ring.end());
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

double area_of(const Triangulation& triangulation) {
    double area = 0.0;
    for (const auto& [a, b, c] : triangulation.triangles) {
        area += signed_area({triangulation.points[a], triangulation.points[b], triangulation.points[c]});
    }
    return area;
}

}  // namespace

Triangulation PlanGeometry::triangulated(const Polygon& polygon) const {
    Triangulation result;
    add_triangles(polygon, 0, result);
    return result;
}

/// GEOS' ear clipping doesn't find ears in some polygons whose holes are in one line: halves of them do.
void PlanGeometry::add_triangles(const Polygon& polygon, int depth, Triangulation& result) const {
    constexpr int kMostCuts = 8;
    constexpr double kMissing = 1e-6;  // of the area
    const Triangulation whole = triangles_of(polygon, *geos_);
    const double area = area_of({polygon});
    if (std::abs(area_of(whole) - area) <= kMissing * area + 1e-5) {
        const auto first = static_cast<std::uint32_t>(result.points.size());
        result.points.insert(result.points.end(), whole.points.begin(), whole.points.end());
        for (const auto& [a, b, c] : whole.triangles) {
            result.triangles.push_back({first + a, first + b, first + c});
        }
        return;
    }
    if (depth == kMostCuts) {
        geos_->note_failure();
        return;
    }
    const Box box = box_of(Polygons{polygon});
    const Point size = box.size();
    Point middle = box.max;
    const Eigen::Index axis = size.x() > size.y() ? 0 : 1;
    middle[axis] = std::round((box.min[axis] + 0.47 * size[axis]) / kGrid) * kGrid;
    Point other = box.min;
    other[axis] = middle[axis];
    for (const Box& half : {Box{box.min, middle}, Box{other, box.max}}) {
        for (const Polygon& part : clipped({polygon}, half)) {
            add_triangles(part, depth + 1, result);
        }
    }
}

void PlanGeometry::charge_to(const std::string& name) const {
    geos_->budget().charge_to(name);
}

std::size_t PlanGeometry::failures() const {
    return geos_->failures();
}

Ring PlanGeometry::least_rectangle(const Ring& ring) const {
    const GeosContext::Geometry area = geos_->geometry(Polygon{ring, {}});
    const GeosContext::Geometry rectangle =
        area ? geos_->own(GEOSMinimumRotatedRectangle_r(geos_->handle(), area.get())) : nullptr;
    if (!rectangle || GEOSGeomTypeId_r(geos_->handle(), rectangle.get()) != GEOS_POLYGON) {
        return {};
    }
    Ring vertices = geos_->ring_of(GEOSGetExteriorRing_r(geos_->handle(), rectangle.get()), true);
    if (vertices.size() != 4) {
        return {};
    }
    if ((vertices[1] - vertices[0]).norm() < (vertices[2] - vertices[1]).norm()) {
        std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
    }
    return vertices;
}

}  // namespace campuswalk::scene::osm
