#include "scene/osm/geometry/overlay_budget.h"

#include <algorithm>
#include <array>

namespace campuswalk::scene::osm {
namespace {

// Microseconds at most, measured with GEOS 3.11: real maps take a third of that.
constexpr std::uint64_t kOperation = 50;
constexpr std::uint64_t kCoordinate = 3;
constexpr std::uint64_t kCrossing = 25;
constexpr std::uint64_t kTestsPerMicrosecond = 100;
constexpr std::uint64_t kVertex = 10;  // of a polygon that is triangulated
constexpr std::uint64_t kVertexPairsPerMicrosecond = 300;

/// Pairs of one operation: about two seconds. GEOS keeps them in an unbalanced tree, in which the time grows
/// with their square.
constexpr std::size_t kMostCrossings = 60'000;
constexpr std::uint64_t kMostTests = 300'000'000;

/// Positive if c is on the left of the line from a to b.
double side_of(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether the line through a segment has the ends of another on both sides, or one on it.
bool divides(const Segment& line, const Segment& other) {
    const double from = side_of(line.from, line.to, other.from);
    const double to = side_of(line.from, line.to, other.to);
    return (from <= 0.0 && to >= 0.0) || (from >= 0.0 && to <= 0.0);
}

/// A segment and its extent along two axes.
struct Extent {
    double low = 0.0;
    double high = 0.0;
    double other_low = 0.0;
    double other_high = 0.0;
    std::uint32_t segment = 0;
};

/// Sorted along the axis on which fewer of them overlap.
std::vector<Extent> extents_of(const std::vector<Segment>& segments) {
    Point total = Point::Zero();
    for (const Segment& segment : segments) {
        total += (segment.to - segment.from).cwiseAbs();
    }
    const Eigen::Index axis = total.x() <= total.y() ? 0 : 1;
    std::vector<Extent> extents;
    extents.reserve(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Point low = segments[i].from.cwiseMin(segments[i].to);
        const Point high = segments[i].from.cwiseMax(segments[i].to);
        extents.push_back(
            {low[axis], high[axis], low[1 - axis], high[1 - axis], static_cast<std::uint32_t>(i)});
    }
    std::ranges::sort(extents, [](const Extent& a, const Extent& b) {
        return a.low < b.low || (a.low == b.low && a.segment < b.segment);
    });
    return extents;
}

struct SegmentPairs {
    std::size_t pairs = 0;
    std::uint64_t tests = 0;  ///< made to find them
};

/// Of neighbours in lines none. Stops counting at the limits above.
SegmentPairs pairs_of(const std::vector<Segment>& segments) {
    SegmentPairs found;
    const std::vector<Extent> extents = extents_of(segments);
    for (std::size_t i = 0; i < extents.size(); ++i) {
        const Extent& a = extents[i];
        std::size_t k = i + 1;
        for (; k < extents.size() && extents[k].low <= a.high; ++k) {
            const Extent& b = extents[k];
            if (b.other_low <= a.other_high && a.other_low <= b.other_high &&
                divides(segments[a.segment], segments[b.segment]) &&
                divides(segments[b.segment], segments[a.segment])) {
                ++found.pairs;
            }
        }
        found.tests += k - i;
        if (found.pairs > kMostCrossings + segments.size() || found.tests > kMostTests) {
            break;
        }
    }
    found.pairs -= std::min(found.pairs, segments.size());
    return found;
}

}  // namespace

void append_segments(const std::vector<Point>& line, std::vector<Segment>& segments) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        segments.push_back({line[i - 1], line[i]});
    }
}

void append_segments(const Polygons& polygons, std::vector<Segment>& segments) {
    const auto append_ring = [&](const Ring& ring) {
        append_segments(ring, segments);
        segments.push_back({ring.back(), ring.front()});
    };
    for (const Polygon& polygon : polygons) {
        append_ring(polygon.outer);
        std::ranges::for_each(polygon.holes, append_ring);
    }
}

std::size_t OverlayBudget::spend(const std::vector<Segment>& segments) {
    const SegmentPairs found = pairs_of(segments);
    if (found.pairs > kMostCrossings || found.tests > kMostTests) {
        throw OverlaysTooCostly(charged_, costs_[charged_], allowed_, true);
    }
    take(kOperation + kCoordinate * segments.size() + kCrossing * found.pairs +
         found.tests / kTestsPerMicrosecond);
    return found.pairs;
}

void OverlayBudget::spend_on_union(std::vector<Segment> segments) {
    const std::size_t coordinates = segments.size();
    const auto key = [](const Segment& segment) {
        return std::array{segment.from.x(), segment.from.y(), segment.to.x(), segment.to.y()};
    };
    for (Segment& segment : segments) {
        if (std::pair(segment.to.x(), segment.to.y()) < std::pair(segment.from.x(), segment.from.y())) {
            std::swap(segment.from, segment.to);
        }
    }
    std::ranges::sort(segments, {}, key);
    segments.erase(std::unique(segments.begin(), segments.end(),
                               [&](const Segment& a, const Segment& b) { return key(a) == key(b); }),
                   segments.end());
    spend(segments);
    take(kCoordinate * (coordinates - segments.size()));
}

void OverlayBudget::spend(std::size_t coordinates) {
    take(kOperation + kCoordinate * coordinates);
}

void OverlayBudget::spend_on_triangles(std::size_t vertices) {
    take(kOperation + kVertex * vertices + vertices * vertices / kVertexPairsPerMicrosecond);
}

void OverlayBudget::take(std::uint64_t cost) {
    costs_[charged_] += cost;
    if (cost > left_) {
        const auto most =
            std::ranges::max_element(costs_, {}, [](const auto& of_one) { return of_one.second; });
        throw OverlaysTooCostly(most->first, most->second, allowed_, false);
    }
    left_ -= cost;
}

}  // namespace campuswalk::scene::osm
