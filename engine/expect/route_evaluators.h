#pragma once

#include "engine/expect/finding.h"

namespace campuswalk::engine {

// Evaluators of expectations about what the campus would let a visitor walk. They are answered before the
// first tick, with every object enabled, by a body of the expectation's or the walk's avatar that is put down
// at the first target.

/// Whether there is a route, and why not if there is none.
Finding check_route(const ExpectReachable& expected, const EvaluatorContext& context);
/// Whether the route is as expected: length, width and slope.
Finding check_route(const ExpectRoute& expected, const EvaluatorContext& context);

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
    using RouteEvaluator::RouteEvaluator;
};

template <>
class EvaluatorOf<ExpectRoute> : public RouteEvaluator<ExpectRoute> {
    using RouteEvaluator::RouteEvaluator;
};

}  // namespace campuswalk::engine
