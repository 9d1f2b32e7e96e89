#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/osm/geometry/plan.h"

namespace campuswalk::scene::osm {

/// Thrown when a map's overlays cost more than they may, in microseconds of a usual machine.
struct OverlaysTooCostly : std::exception {
    std::string costliest;       ///< what most was charged to, such as "footway/way-12"; may be empty
    std::uint64_t its_cost = 0;  ///< what that has cost so far
    std::uint64_t allowed = 0;   ///< for the whole map
    bool one_operation = false;  ///< the next operation for it is too much by itself

    OverlaysTooCostly(std::string name, std::uint64_t cost, std::uint64_t limit, bool in_one)
        : costliest(std::move(name)), its_cost(cost), allowed(limit), one_operation(in_one) {}
};

struct Segment {
    Point from = Point::Zero();
    Point to = Point::Zero();
};

/// The segments of rings, and of lines.
void append_segments(const Polygons& polygons, std::vector<Segment>& segments);
void append_segments(const std::vector<Point>& line, std::vector<Segment>& segments);

/// What overlays, buffers and triangulations of one map may cost, in microseconds of a usual machine. It is
/// reckoned before an operation from what goes into it, as nothing stops GEOS once it has begun, and never
/// timed, so that a map is refused on every machine or on none.
class OverlayBudget {
public:
    explicit OverlayBudget(std::uint64_t allowed = kAnyMap) : allowed_(allowed), left_(allowed) {}

    /// From now on costs are those of this element of the map, or node of the model.
    void charge_to(const std::string& name) { charged_ = name; }

    /// Twenty seconds, and a millisecond for each node: a campus is reckoned to need a tenth of that, a city
    /// a quarter.
    static OverlayBudget for_map(std::size_t nodes) {
        return OverlayBudget(kAnyMap + 1000 * std::uint64_t{nodes});
    }

    /// An operation that finds all pairs of segments that touch or cross. Throws OverlaysTooCostly if that is
    /// too much for what is left, or for one operation. Returns the number of such pairs, without as many as
    /// there are segments: in lines neighbours touch.
    std::size_t spend(const std::vector<Segment>& segments);
    /// A union of areas: GEOS unites them one by one, so segments that coincide count once.
    void spend_on_union(std::vector<Segment> segments);
    /// One on lines that don't cross.
    void spend(std::size_t coordinates);
    /// One that makes triangles of a polygon: its time grows with the square of the vertices.
    void spend_on_triangles(std::size_t vertices);

private:
    static constexpr std::uint64_t kAnyMap = 20'000'000;

    void take(std::uint64_t cost);

    std::uint64_t allowed_;
    std::uint64_t left_;
    std::string charged_;
    std::map<std::string, std::uint64_t> costs_;
};

}  // namespace campuswalk::scene::osm
