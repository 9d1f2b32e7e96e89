#include "engine/walkspace/explore/frontier.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/walkspace/space/tight_growth.h"

namespace campuswalk::engine {

namespace {

/// Falls are steered up to so many fifths of a second later: what is below an edge is often set back, and a
/// body that steers back at once lands on the edge again. A fall of 5 m takes one second, one of 0.8 m 0.4.
constexpr std::uint8_t kLatestInHighFall = 3;
constexpr std::uint8_t kLatestInLowFall = 1;

/// The earlier first, at the top of a heap.
bool later(const Pending& a, const Pending& b) {
    return std::tie(a.order, a.ticks, a.node) > std::tie(b.order, b.ticks, b.node);
}

}  // namespace

void Frontier::push(const Pending& node) {
    push_tightly(pending_, node);
    std::ranges::push_heap(pending_, later);
}

Pending Frontier::pop() {
    std::ranges::pop_heap(pending_, later);
    Pending next = pending_.back();
    pending_.pop_back();
    if (pending_.size() < pending_.capacity() / 2) {  // most tiles are done at any time
        pending_.shrink_to_fit();
    }
    return next;
}

bool Frontier::push_detour(const Arrival& arrival, std::uint32_t order) {
    if (detours_.size() >= WalkTile::kMaxNodes) {
        return false;
    }
    push({.order = order,
          .ticks = arrival.ticks,
          .node = static_cast<std::uint16_t>(detours_.size()),
          .is_detour = true,
          .at = arrival.at});
    detours_.push_back(arrival);
    return true;
}

bool Frontier::has_sent(const GridCell& cell, double y, bool hangs) const {
    return std::ranges::any_of(outbox, [&](const Arrival& arrival) {
        return arrival.cell == cell &&
               WalkNode::is_one_level(arrival.at.foot.y() - y, hangs || arrival.hangs);
    });
}

std::optional<double> Frontier::level_sent(const GridCell& cell, double y, double tolerance) const {
    std::optional<double> nearest;
    for (const Arrival& arrival : outbox) {
        const double apart = std::abs(arrival.at.foot.y() - y);
        if (arrival.cell == cell && apart <= tolerance) {
            tolerance = apart;
            nearest = arrival.at.foot.y();
        }
    }
    return nearest;
}

void Frontier::keep(const Fall& fall, const GridCell& edge) {
    const float height = fall.edge.y();
    const bool is_known = std::ranges::any_of(edges_, [&](const auto& known) {
        return known.first == edge && std::abs(known.second - height) <= WalkNode::kLevel;
    });
    if (!is_known) {
        push_tightly(edges_, {edge, height});
        push_tightly(falls, fall);
    }
}

std::vector<Stride> steered_strides(const Fall& fall, bool over_the_rim) {
    std::vector<Stride> strides;
    Stride stride = fall.stride();
    const collision::Vec3& ahead = grid_directions()[fall.direction].unit;
    const std::uint8_t latest = fall.high ? kLatestInHighFall : kLatestInLowFall;
    for (std::uint8_t after = over_the_rim ? 1 : 0; after <= latest; ++after) {
        stride.steers_after = after;
        for (std::uint8_t i = 0; i < 8; ++i) {
            // Over the rim of the world, ground can only be behind.
            if (i != fall.direction && (!over_the_rim || grid_directions()[i].unit.dot(ahead) < -0.1)) {
                stride.steering = i;
                strides.push_back(stride);
            }
        }
        if (after > 0 && !over_the_rim) {
            stride.steering = Stride::kLetGo;
            strides.push_back(stride);
        }
    }
    return strides;
}

}  // namespace campuswalk::engine
