#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <geos_c.h>

#include "scene/osm/geometry/overlay_budget.h"
#include "scene/osm/geometry/plan.h"

namespace campuswalk::scene::osm {

/// A context of GEOS: plans as its geometries, on a grid, and what comes back as plans. Its geometries are
/// freed with the context that made them.
class GeosContext {
public:
    struct Free {
        GEOSContextHandle_t context = nullptr;
        void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Free>;

    /// Coordinates become multiples of `grid`, metres.
    GeosContext(double grid, const OverlayBudget& budget);
    ~GeosContext();
    GeosContext(const GeosContext&) = delete;
    GeosContext& operator=(const GeosContext&) = delete;

    GEOSContextHandle_t handle() const { return context_; }
    Geometry own(GEOSGeometry* geometry) const { return Geometry(geometry, Free{context_}); }

    Geometry line(const std::vector<Point>& points) const;
    Geometry lines(const std::vector<std::vector<Point>>& lines) const;
    Geometry geometry(const Polygon& polygon) const;
    Geometry geometry(const Polygons& polygons) const;
    /// Of polygons that may overlap.
    Geometry collection(const std::vector<const Polygons*>& all) const;

    /// Without the repeated last point.
    Ring ring_of(const GEOSGeometry* line, bool counter_clockwise) const;
    /// The areas in the result of an operation; without one a failure is noted.
    Polygons polygons_of(const Geometry& geometry) const;
    /// The same, rounded to the grid and valid.
    Polygons rounded(const Geometry& geometry) const;

    /// Before an operation on areas, or on a line. Returns how many pairs of their segments
    /// touch or cross, as OverlayBudget::spend.
    std::size_t spend_on_areas(const std::vector<const Polygons*>& areas) const;
    void spend_on_union(const std::vector<const Polygons*>& areas) const;
    std::size_t spend_on_line(const std::vector<Point>& line) const;
    OverlayBudget& budget() const { return budget_; }

    /// Throws std::bad_alloc if that was the reason.
    void note_failure() const;
    std::size_t failures() const { return failures_; }

private:
    static void note_error(const char* message, void* self);
    double on_grid(double value) const;
    GEOSCoordSequence* sequence(const std::vector<Point>& points, bool close) const;
    GEOSGeometry* ring(const Ring& points) const;
    std::vector<Point> points_of(const GEOSGeometry* line) const;
    void append(const GEOSGeometry* geometry, Polygons& polygons) const;

    GEOSContextHandle_t context_;
    double grid_;
    double per_metre_;
    bool out_of_memory_ = false;
    mutable std::size_t failures_ = 0;
    mutable OverlayBudget budget_;
};

}  // namespace campuswalk::scene::osm
