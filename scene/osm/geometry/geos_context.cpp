#include "scene/osm/geometry/geos_context.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>
#include <utility>

namespace campuswalk::scene::osm {
namespace {

std::vector<Segment> segments_of(const std::vector<const Polygons*>& areas) {
    std::vector<Segment> segments;
    for (const Polygons* polygons : areas) {
        append_segments(*polygons, segments);
    }
    return segments;
}

}  // namespace

GeosContext::GeosContext(double grid, const OverlayBudget& budget)
    : context_(GEOS_init_r()), grid_(grid), per_metre_(1.0 / grid), budget_(budget) {
    GEOSContext_setErrorMessageHandler_r(context_, note_error, this);
}

GeosContext::~GeosContext() {
    GEOS_finish_r(context_);
}

/// GEOS turns every exception into a message and no result.
void GeosContext::note_error(const char* message, void* self) {
    static_cast<GeosContext*>(self)->out_of_memory_ =
        std::string_view(message).find("bad_alloc") != std::string_view::npos;
}

void GeosContext::note_failure() const {
    if (out_of_memory_) {
        throw std::bad_alloc();
    }
    ++failures_;
}

std::size_t GeosContext::spend_on_areas(const std::vector<const Polygons*>& areas) const {
    return budget_.spend(segments_of(areas));
}

void GeosContext::spend_on_union(const std::vector<const Polygons*>& areas) const {
    budget_.spend_on_union(segments_of(areas));
}

std::size_t GeosContext::spend_on_line(const std::vector<Point>& line) const {
    std::vector<Segment> segments;
    append_segments(line, segments);
    return budget_.spend(segments);
}

// Plans to geometries.

double GeosContext::on_grid(double value) const {
    return std::round(value * per_metre_) / per_metre_;  // as GEOS does
}

GEOSCoordSequence* GeosContext::sequence(const std::vector<Point>& points, bool close) const {
    const auto count = static_cast<unsigned>(points.size());
    GEOSCoordSequence* coordinates = GEOSCoordSeq_create_r(context_, count + (close ? 1U : 0U), 2);
    for (unsigned i = 0; i < count; ++i) {
        GEOSCoordSeq_setXY_r(context_, coordinates, i, on_grid(points[i].x()), on_grid(points[i].y()));
    }
    if (close) {
        GEOSCoordSeq_setXY_r(context_, coordinates, count, on_grid(points[0].x()), on_grid(points[0].y()));
    }
    return coordinates;
}

GeosContext::Geometry GeosContext::line(const std::vector<Point>& points) const {
    return own(GEOSGeom_createLineString_r(context_, sequence(points, false)));
}

GeosContext::Geometry GeosContext::lines(const std::vector<std::vector<Point>>& lines) const {
    std::vector<GEOSGeometry*> parts;
    for (const std::vector<Point>& points : lines) {
        if (points.size() >= 2) {
            parts.push_back(line(points).release());
        }
    }
    return own(GEOSGeom_createCollection_r(context_, GEOS_MULTILINESTRING, parts.data(),
                                           static_cast<unsigned>(parts.size())));
}

GEOSGeometry* GeosContext::ring(const Ring& points) const {
    return GEOSGeom_createLinearRing_r(context_, sequence(points, true));
}

GeosContext::Geometry GeosContext::geometry(const Polygon& polygon) const {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes) {
        holes.push_back(ring(hole));
    }
    return own(GEOSGeom_createPolygon_r(context_, ring(polygon.outer), holes.data(),
                                        static_cast<unsigned>(holes.size())));
}

GeosContext::Geometry GeosContext::geometry(const Polygons& polygons) const {
    return polygons.size() == 1 ? geometry(polygons.front()) : collection({&polygons});
}

GeosContext::Geometry GeosContext::collection(const std::vector<const Polygons*>& all) const {
    std::vector<GEOSGeometry*> parts;
    for (const Polygons* polygons : all) {
        for (const Polygon& polygon : *polygons) {
            if (Geometry part = geometry(polygon)) {
                parts.push_back(part.release());
            }
        }
    }
    return own(GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, parts.data(),
                                           static_cast<unsigned>(parts.size())));
}

// Geometries to plans.

std::vector<Point> GeosContext::points_of(const GEOSGeometry* line) const {
    const GEOSCoordSequence* coordinates = GEOSGeom_getCoordSeq_r(context_, line);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(context_, coordinates, &count);
    std::vector<Point> points(count);
    for (unsigned i = 0; i < count; ++i) {
        GEOSCoordSeq_getXY_r(context_, coordinates, i, &points[i].x(), &points[i].y());
    }
    return points;
}

Ring GeosContext::ring_of(const GEOSGeometry* line, bool counter_clockwise) const {
    Ring ring = points_of(line);
    ring.pop_back();
    if ((signed_area(ring) > 0.0) != counter_clockwise) {
        std::reverse(ring.begin(), ring.end());
    }
    return ring;
}

void GeosContext::append(const GEOSGeometry* geometry, Polygons& polygons) const {
    constexpr double kLeastArea = 1e-4;  // m²
    if (geometry == nullptr || GEOSisEmpty_r(context_, geometry) != 0) {
        return;
    }
    const int type = GEOSGeomTypeId_r(context_, geometry);
    if (type == GEOS_POLYGON) {
        Polygon polygon{ring_of(GEOSGetExteriorRing_r(context_, geometry), true), {}};
        if (signed_area(polygon.outer) < kLeastArea) {
            return;
        }
        for (int i = 0; i < GEOSGetNumInteriorRings_r(context_, geometry); ++i) {
            Ring hole = ring_of(GEOSGetInteriorRingN_r(context_, geometry, i), false);
            if (hole.size() >= 3) {
                polygon.holes.push_back(std::move(hole));
            }
        }
        polygons.push_back(std::move(polygon));
    } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
        for (int i = 0; i < GEOSGetNumGeometries_r(context_, geometry); ++i) {
            append(GEOSGetGeometryN_r(context_, geometry, i), polygons);
        }
    }
}

Polygons GeosContext::polygons_of(const Geometry& geometry) const {
    Polygons polygons;
    if (!geometry) {
        note_failure();
    }
    append(geometry.get(), polygons);
    return polygons;
}

Polygons GeosContext::rounded(const Geometry& geometry) const {
    return polygons_of(geometry ? own(GEOSGeom_setPrecision_r(context_, geometry.get(), grid_, 0))
                                : own(nullptr));
}

}  // namespace campuswalk::scene::osm
