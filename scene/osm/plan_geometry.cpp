#include "scene/osm/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>
#include <utility>

#include <geos_c.h>

namespace campuswalk::scene::osm {

/// Everything that GEOS needs; its geometries are freed with the context that made them.
struct PlanGeometry::Impl {
    struct Free {
        GEOSContextHandle_t context = nullptr;
        void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Free>;

    Impl() : context(GEOS_init_r()) { GEOSContext_setErrorMessageHandler_r(context, note_error, this); }
    ~Impl() { GEOS_finish_r(context); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// GEOS turns every exception into a message and no result.
    static void note_error(const char* message, void* self) {
        static_cast<Impl*>(self)->out_of_memory =
            std::string_view(message).find("bad_alloc") != std::string_view::npos;
    }
    void note_failure() const {
        if (out_of_memory) {
            throw std::bad_alloc();
        }
        ++failures;
    }

    static constexpr double kPerMetre = 1.0 / kGrid;

    Geometry own(GEOSGeometry* geometry) const { return Geometry(geometry, Free{context}); }

    static double on_grid(double value) { return std::round(value * kPerMetre) / kPerMetre; }  // as GEOS does

    GEOSCoordSequence* sequence(const std::vector<Point>& points, bool close) const {
        const auto count = static_cast<unsigned>(points.size());
        GEOSCoordSequence* coordinates = GEOSCoordSeq_create_r(context, count + (close ? 1U : 0U), 2);
        for (unsigned i = 0; i < count; ++i) {
            GEOSCoordSeq_setXY_r(context, coordinates, i, on_grid(points[i].x()), on_grid(points[i].y()));
        }
        if (close) {
            GEOSCoordSeq_setXY_r(context, coordinates, count, on_grid(points[0].x()), on_grid(points[0].y()));
        }
        return coordinates;
    }

    Geometry line(const std::vector<Point>& points) const {
        return own(GEOSGeom_createLineString_r(context, sequence(points, false)));
    }

    GEOSGeometry* ring(const Ring& points) const {
        return GEOSGeom_createLinearRing_r(context, sequence(points, true));
    }

    Geometry geometry(const Polygon& polygon) const {
        std::vector<GEOSGeometry*> holes;
        for (const Ring& hole : polygon.holes) {
            holes.push_back(ring(hole));
        }
        return own(GEOSGeom_createPolygon_r(context, ring(polygon.outer), holes.data(),
                                            static_cast<unsigned>(holes.size())));
    }

    Geometry geometry(const Polygons& polygons) const {
        if (polygons.size() == 1) {
            return geometry(polygons.front());
        }
        std::vector<GEOSGeometry*> parts;
        for (const Polygon& polygon : polygons) {
            if (Geometry part = geometry(polygon)) {
                parts.push_back(part.release());
            }
        }
        return own(GEOSGeom_createCollection_r(context, GEOS_MULTIPOLYGON, parts.data(),
                                               static_cast<unsigned>(parts.size())));
    }

    std::vector<Point> points_of(const GEOSGeometry* line) const {
        const GEOSCoordSequence* coordinates = GEOSGeom_getCoordSeq_r(context, line);
        unsigned count = 0;
        GEOSCoordSeq_getSize_r(context, coordinates, &count);
        std::vector<Point> points(count);
        for (unsigned i = 0; i < count; ++i) {
            GEOSCoordSeq_getXY_r(context, coordinates, i, &points[i].x(), &points[i].y());
        }
        return points;
    }

    Ring ring_of(const GEOSGeometry* line, bool counter_clockwise) const {
        Ring ring = points_of(line);
        ring.pop_back();
        if ((signed_area(ring) > 0.0) != counter_clockwise) {
            std::reverse(ring.begin(), ring.end());
        }
        return ring;
    }

    void append(const GEOSGeometry* geometry, Polygons& polygons) const {
        constexpr double kLeastArea = 1e-4;  // m²
        if (geometry == nullptr || GEOSisEmpty_r(context, geometry) != 0) {
            return;
        }
        const int type = GEOSGeomTypeId_r(context, geometry);
        if (type == GEOS_POLYGON) {
            Polygon polygon{ring_of(GEOSGetExteriorRing_r(context, geometry), true), {}};
            if (signed_area(polygon.outer) < kLeastArea) {
                return;
            }
            for (int i = 0; i < GEOSGetNumInteriorRings_r(context, geometry); ++i) {
                Ring hole = ring_of(GEOSGetInteriorRingN_r(context, geometry, i), false);
                if (hole.size() >= 3) {
                    polygon.holes.push_back(std::move(hole));
                }
            }
            polygons.push_back(std::move(polygon));
        } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
            for (int i = 0; i < GEOSGetNumGeometries_r(context, geometry); ++i) {
                append(GEOSGetGeometryN_r(context, geometry, i), polygons);
            }
        }
    }

    void count_operation() const {
        if (++operations > kMaxOperations) {
            throw TooManyOperations();
        }
    }

    Polygons polygons_of(const Geometry& geometry) const {
        count_operation();
        Polygons polygons;
        if (!geometry) {
            note_failure();
        }
        append(geometry.get(), polygons);
        return polygons;
    }

    /// Rounded to the grid, and valid.
    Polygons rounded(const Geometry& geometry) const {
        return polygons_of(geometry ? own(GEOSGeom_setPrecision_r(context, geometry.get(), kGrid, 0))
                                    : own(nullptr));
    }

    /// Triangles of what GEOS can triangulate; of the rest their area is missing.
    void triangulate(const Polygon& polygon, Triangulation& result) const {
        count_operation();
        const Geometry area = geometry(polygon);
        const Geometry triangles =
            area ? own(GEOSConstrainedDelaunayTriangulation_r(context, area.get())) : nullptr;
        const int count = triangles ? GEOSGetNumGeometries_r(context, triangles.get()) : 0;
        for (int i = 0; i < count; ++i) {
            const GEOSGeometry* triangle = GEOSGetGeometryN_r(context, triangles.get(), i);
            const Ring ring = ring_of(GEOSGetExteriorRing_r(context, triangle), true);
            if (ring.size() != 3 || signed_area(ring) <= 0.0) {
                continue;
            }
            const auto first = static_cast<std::uint32_t>(result.points.size());
            result.points.insert(result.points.end(), ring.begin(), ring.end());
            result.triangles.push_back({first, first + 1, first + 2});
        }
    }

    GEOSContextHandle_t context;
    bool out_of_memory = false;
    mutable std::size_t failures = 0;
    mutable std::size_t operations = 0;
};

namespace {

constexpr std::size_t kPieceOfLine = 128;  // points

}  // namespace

PlanGeometry::PlanGeometry() : impl_(std::make_unique<Impl>()) {}
PlanGeometry::~PlanGeometry() = default;

Polygons PlanGeometry::polygon(const Ring& ring) const {
    if (ring.size() < 3) {
        return {};
    }
    const Impl::Geometry raw = impl_->geometry(Polygon{ring, {}});
    if (!raw) {
        return {};
    }
    if (GEOSisValid_r(impl_->context, raw.get()) == 1) {
        return impl_->polygons_of(raw);
    }
    return impl_->rounded(impl_->own(GEOSMakeValid_r(impl_->context, raw.get())));
}

Polygons PlanGeometry::areas_of_lines(const std::vector<std::vector<Point>>& lines) const {
    std::vector<GEOSGeometry*> parts;
    for (const std::vector<Point>& line : lines) {
        if (line.size() >= 2) {
            parts.push_back(impl_->line(line).release());
        }
    }
    const Impl::Geometry all = impl_->own(GEOSGeom_createCollection_r(
        impl_->context, GEOS_MULTILINESTRING, parts.data(), static_cast<unsigned>(parts.size())));
    if (!all) {
        return {};
    }
    const Impl::Geometry noded = impl_->own(GEOSNode_r(impl_->context, all.get()));
    return noded ? impl_->rounded(impl_->own(GEOSBuildArea_r(impl_->context, noded.get()))) : Polygons();
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
    if (line.size() > kPieceOfLine && caps != Caps::square) {
        return buffer_in_pieces(line, radius, caps);
    }
    const Impl::Geometry path = impl_->line(line);
    return impl_->rounded(impl_->own(
        GEOSBufferWithStyle_r(impl_->context, path.get(), radius, kQuarterSegments, cap,
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
    const Impl::Geometry path = impl_->line(line);
    GEOSBufferParams* params = GEOSBufferParams_create_r(impl_->context);
    GEOSBufferParams_setSingleSided_r(impl_->context, params, 1);
    GEOSBufferParams_setJoinStyle_r(impl_->context, params, GEOSBUF_JOIN_MITRE);
    GEOSBufferParams_setMitreLimit_r(impl_->context, params, kMitreLimit);
    const Impl::Geometry side =
        impl_->own(GEOSBufferWithParams_r(impl_->context, path.get(), params, distance));
    GEOSBufferParams_destroy_r(impl_->context, params);
    return impl_->rounded(side);
}

Polygons PlanGeometry::grown(const Polygons& polygons, double by) const {
    constexpr int kQuarterSegments = 4;
    constexpr double kMitreLimit = 2.0;
    if (polygons.empty()) {
        return {};
    }
    const Impl::Geometry area = impl_->geometry(polygons);
    return impl_->rounded(
        impl_->own(GEOSBufferWithStyle_r(impl_->context, area.get(), by, kQuarterSegments, GEOSBUF_CAP_FLAT,
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
    const Impl::Geometry first = impl_->geometry(a);
    const Impl::Geometry second = impl_->geometry(b);
    return GEOSIntersects_r(impl_->context, first.get(), second.get()) != 0;  // or it failed
}

Polygons PlanGeometry::difference(const Polygons& a, const Polygons& b) const {
    if (a.empty() || b.empty() || !box_of(a).overlaps(box_of(b))) {
        return a;
    }
    const Impl::Geometry from = impl_->geometry(a);
    const Impl::Geometry cut = impl_->geometry(b);
    const Impl::Geometry rest =
        impl_->own(GEOSDifferencePrec_r(impl_->context, from.get(), cut.get(), kGrid));
    Polygons polygons = impl_->polygons_of(rest);
    return rest ? polygons : a;  // rather twice than not at all
}

Polygons PlanGeometry::intersection(const Polygons& a, const Polygons& b) const {
    if (a.empty() || b.empty() || !box_of(a).overlaps(box_of(b))) {
        return {};
    }
    const Impl::Geometry first = impl_->geometry(a);
    const Impl::Geometry second = impl_->geometry(b);
    return impl_->polygons_of(
        impl_->own(GEOSIntersectionPrec_r(impl_->context, first.get(), second.get(), kGrid)));
}

Polygons PlanGeometry::united(const std::vector<const Polygons*>& all) const {
    std::vector<GEOSGeometry*> parts;
    for (const Polygons* polygons : all) {
        for (const Polygon& polygon : *polygons) {
            if (Impl::Geometry part = impl_->geometry(polygon)) {
                parts.push_back(part.release());
            }
        }
    }
    const Impl::Geometry collection = impl_->own(GEOSGeom_createCollection_r(
        impl_->context, GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())));
    return impl_->polygons_of(impl_->own(GEOSUnaryUnionPrec_r(impl_->context, collection.get(), kGrid)));
}

namespace {

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
    Triangulation whole;
    impl_->triangulate(polygon, whole);
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
        impl_->note_failure();
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

std::size_t PlanGeometry::failures() const {
    return impl_->failures;
}

Ring PlanGeometry::least_rectangle(const Ring& ring) const {
    const Impl::Geometry area = impl_->geometry(Polygon{ring, {}});
    const Impl::Geometry rectangle =
        area ? impl_->own(GEOSMinimumRotatedRectangle_r(impl_->context, area.get())) : nullptr;
    if (!rectangle || GEOSGeomTypeId_r(impl_->context, rectangle.get()) != GEOS_POLYGON) {
        return {};
    }
    Ring vertices = impl_->ring_of(GEOSGetExteriorRing_r(impl_->context, rectangle.get()), true);
    if (vertices.size() != 4) {
        return {};
    }
    if ((vertices[1] - vertices[0]).norm() < (vertices[2] - vertices[1]).norm()) {
        std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
    }
    return vertices;
}

}  // namespace campuswalk::scene::osm
