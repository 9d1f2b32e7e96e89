#pragma once

#include <cstddef>
#include <optional>

#include "engine/expect/finding.h"
#include "engine/script/travel.h"

namespace campuswalk::engine {

// Evaluators of expectations about what the campus would let a visitor walk. They are answered before the
// first tick, with every object enabled, by a body of the expectation's or the walk's avatar that is put down
// at the first target.

/// Whether there is a route, and why not if there is none. Without `max_nodes`, as many are explored as
/// RouteSettings allows; if that isn't all, the finding has a lack.
Finding check_route(const ExpectReachable& expected, const EvaluatorContext& context,
                    std::optional<std::size_t> max_nodes = {});
/// Whether the route is as expected: length, width and slope.
Finding check_route(const ExpectRoute& expected, const EvaluatorContext& context,
                    std::optional<std::size_t> max_nodes = {});

/// What holds from the start on.
template <typename Expected>
class RouteEvaluator {
public:
    RouteEvaluator(const Expected& expected, const EvaluatorContext& context)
        : finding_(check_route(expected, context)) {}

    void on_tick(const TickRecord& /*record*/, const StateSnapshot& /*now*/) {}
    Finding finding(bool /*ended*/) const { return finding_; }

private:
    Finding finding_;
};

template <>
class EvaluatorOf<ExpectReachable> : public RouteEvaluator<ExpectReachable> {
public:
    using RouteEvaluator::RouteEvaluator;
    static PossibleVerdicts possible(const ExpectReachable& /*expected*/, const WalkBounds& /*bounds*/) {
        return {};
    }
};

template <>
class EvaluatorOf<ExpectRoute> : public RouteEvaluator<ExpectRoute> {
public:
    using RouteEvaluator::RouteEvaluator;
    /// No route is shorter than the straight line, but that it ends near the target.
    static PossibleVerdicts possible(const ExpectRoute& expected, const WalkBounds& /*bounds*/) {
        constexpr double kNear = 1.0;  // metres
        const double straight = flat(expected.to.point - expected.from.point).norm();
        return {.holds = !expected.max_length || *expected.max_length >= straight - kNear};
    }
};

}  // namespace campuswalk::engine
