#include "engine/walkspace/barrier/smallest_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campuswalk::engine {

namespace {

/// Taking an object away counts as much as changing the body by this share, or climbing so much higher,
/// metres.
constexpr double kChangeOfObject = 0.6;
/// A node of a mesh a little more: rather the door that somebody put there than a part of the house.
constexpr double kChangeOfNode = 0.61;
/// Of objects of about one size, the one without which the way is the shortest, if it is by so much.
constexpr double kAboutOneSize = 1.25;
constexpr double kMuchShorter = 0.8;

/// How much the body would have to change: of heights, in metres; else the share of what it has.
double amount_of(const Change& change) {
    const Barrier& barrier = change.barrier;
    if (barrier.kind == ReasonKind::object) {
        return barrier.is_node ? kChangeOfNode : kChangeOfObject;
    }
    const bool climb = barrier.kind == ReasonKind::riser || barrier.kind == ReasonKind::ledge;
    return std::abs(barrier.measured - barrier.allowed) / (climb ? 1.0 : barrier.allowed);
}

void order(std::vector<Change>& changes) {
    const auto smaller = [](const Change& change) { return std::pair(amount_of(change), change.size); };
    std::ranges::stable_sort(changes, {}, smaller);
    const Change smallest = changes.front();
    const auto end = std::ranges::find_if(changes, [&](const Change& change) {
        return amount_of(change) != amount_of(smallest) || change.size > kAboutOneSize * smallest.size;
    });
    const auto shortest = std::ranges::min_element(changes.begin(), end, {}, &Change::length);
    if (shortest->length < kMuchShorter * smallest.length) {
        std::rotate(changes.begin(), shortest, shortest + 1);
    }
}

}  // namespace

bool is_small_climb(const Change& change) {
    const ReasonKind kind = change.barrier.kind;
    const bool is_climb = kind == ReasonKind::riser || kind == ReasonKind::ledge || kind == ReasonKind::slope;
    return is_climb && amount_of(change) <= kChangeOfNode;
}

Barrier smallest_of(std::vector<Change> changes) {
    order(changes);
    Barrier smallest = changes.front().barrier;
    for (std::size_t i = 1; i < changes.size(); ++i) {
        smallest.parts.push_back(changes[i].barrier);
    }
    return smallest;
}

}  // namespace campuswalk::engine
