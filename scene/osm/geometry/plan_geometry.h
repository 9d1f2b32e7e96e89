#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene/osm/geometry/overlay_budget.h"
#include "scene/osm/geometry/plan.h"

namespace campuswalk::scene::osm {

/// Triangles of polygons; indices into `points`, counter-clockwise.
struct Triangulation {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

enum class Caps { round, flat, square };

class GeosContext;

/// Overlays of GEOS. Coordinates come out as multiples of kGrid, which makes its overlays robust. The same
/// version of GEOS gives the same everywhere; triangles, buffers and rectangles may change with it. What has
/// no area is left out.
class PlanGeometry {
public:
    static constexpr double kGrid = 0.001;  ///< metres

    explicit PlanGeometry(const OverlayBudget& budget = OverlayBudget());
    ~PlanGeometry();
    PlanGeometry(const PlanGeometry&) = delete;
    PlanGeometry& operator=(const PlanGeometry&) = delete;

    /// A valid polygon from a ring that may cross itself: what it goes around an odd number of times. Nothing
    /// from one that does so more than 100 times.
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
    /// What is in one of them and not in both.
    Polygons symmetric_difference(const Polygons& a, const Polygons& b) const;
    Polygons united(const std::vector<const Polygons*>& all) const;
    Triangulation triangulated(const Polygon& polygon) const;
    /// From now on overlays are charged to this element of the map, or node of the model: what is named when
    /// they cost too much.
    void charge_to(const std::string& name) const;
    /// How often GEOS failed: something is missing, or there twice.
    std::size_t failures() const;
    /// The least rectangle around a ring, counter-clockwise, its first edge the longer; empty if there is
    /// none. What is least depends on GEOS: to 3.11 the narrowest, whose width is the ring's least diameter.
    Ring least_rectangle(const Ring& ring) const;

private:
    Polygons buffer_in_pieces(const std::vector<Point>& line, double radius, Caps caps) const;
    void add_triangles(const Polygon& polygon, int depth, Triangulation& result) const;

    std::unique_ptr<GeosContext> geos_;
};

}  // namespace campuswalk::scene::osm
