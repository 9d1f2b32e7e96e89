#include "collision/world/overlap_span.h"

#include <algorithm>
#include <vector>

#include "collision/geometry/closest.h"
#include "collision/world/obstacle.h"
#include "collision/world/placement.h"

namespace campuswalk::collision {

namespace {

/// The span of one convex piece: by a sweep from the start and a sweep back from the end.
std::optional<OverlapSpan> span_of(const Segment& segment, double radius, const Vec3& move,
                                   const Obstacle& piece) {
    const Segment end{segment.a + move, segment.b + move};
    OverlapSpan span;
    span.at_start = closest(segment, piece).distance <= radius;
    span.at_end = closest(end, piece).distance <= radius;
    if (!span.at_start) {
        const auto enter = sweep(segment, radius, move, piece);
        if (!enter && !span.at_end) {
            return std::nullopt;
        }
        span.enter = enter.value_or(1.0);
    }
    if (!span.at_end) {
        span.leave = 1.0 - sweep(end, radius, -move, piece).value_or(1.0);
        span.leave = std::max(span.leave, span.enter);
    }
    return span;
}

void merge(std::optional<OverlapSpan>& total, const OverlapSpan& span) {
    if (!total) {
        total = span;
        return;
    }
    total->enter = std::min(total->enter, span.enter);
    total->leave = std::max(total->leave, span.leave);
    total->at_start = total->at_start || span.at_start;
    total->at_end = total->at_end || span.at_end;
}

}  // namespace

std::optional<OverlapSpan> overlap_span(const World& world, ObjectId id, const Segment& segment,
                                        double radius, const Vec3& move, QueryStatistics* statistics) {
    const bool inside_at_start = contains(world.object(id), segment.a, statistics);
    const bool inside_at_end = contains(world.object(id), segment.a + move, statistics);
    const OverlapSpan inside{.enter = inside_at_start ? 0.0 : 1.0,
                             .leave = inside_at_end ? 1.0 : 0.0,
                             .at_start = inside_at_start,
                             .at_end = inside_at_end};
    if (inside_at_start && inside_at_end) {
        return inside;  // no piece can extend that
    }
    thread_local std::vector<Obstacle> pieces;
    const Segment middle{segment.a + 0.5 * move, segment.b + 0.5 * move};
    gather_pieces(world, id, middle, radius + 0.5 * move.norm(), pieces, statistics);
    std::optional<OverlapSpan> total;
    for (const Obstacle& piece : pieces) {
        if (const auto span = span_of(segment, radius, move, piece)) {
            merge(total, *span);
        }
    }
    // Deep inside a closed mesh no surface is near; crossing the surface is in the pieces' spans already.
    if (inside_at_start || inside_at_end) {
        merge(total, inside);
    }
    return total;
}

}  // namespace campuswalk::collision
