#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/events/decimals.h"
#include "engine/expect/route_evaluators.h"
#include "engine/walkspace/campus_route.h"
#include "engine/walkspace/route_facts.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A route, or why there is none.
struct FoundRoute {
    std::optional<Route> route;
    UnreachableReason why_not;
    RouteSettings settings;
};

template <typename Expected>
FoundRoute find_route(const Expected& expected, const EvaluatorContext& context,
                      std::optional<std::size_t> max_nodes) {
    FoundRoute found;
    found.settings = route_settings(context.campus, expected.avatar.value_or(context.avatar), nullptr);
    found.settings.max_nodes = max_nodes.value_or(found.settings.max_nodes);
    const auto body =
        body_at(route_start(expected.from, context.campus.description), context.campus, found.settings);
    if (!body) {
        found.why_not.text = "the avatar doesn't fit at " + expected.from.label;
        return found;
    }
    auto answer = route_or_reason(context.campus, found.settings, {*body, {expected.to}});
    if (auto* route = std::get_if<Route>(&answer)) {
        found.route = std::move(*route);
    } else {
        found.why_not = std::get<UnreachableReason>(std::move(answer));
    }
    return found;
}

template <typename Expected>
Finding no_route(const Expected& expected, const UnreachableReason& why) {
    const std::string there = expected.to.label + " from " + expected.from.label + ": " + why.text;
    Finding finding{false, expected.mark, "no route leads to " + there, {}};
    if (why.incomplete) {
        finding.lack = kRouteUnknown;
        finding.message = "it isn't known whether a route leads to " + there;
    }
    return finding;
}

std::string at_text(const Vec3& p) {
    return " at " + coordinates_text(p);
}

/// The first thing about the route that isn't as expected; empty if all is.
std::string violation(const ExpectRoute& expected, const Route& route, const RouteFacts& facts) {
    if (expected.max_length && route.length() > *expected.max_length) {
        return "is " + in_metres(route.length()) + " long, expected at most " +
               in_metres(*expected.max_length);
    }
    if (expected.min_width && facts.narrowest && facts.narrowest->value < *expected.min_width) {
        return "is " + in_metres(facts.narrowest->value) + " wide" + at_text(facts.narrowest->at) +
               ", expected at least " + in_metres(*expected.min_width);
    }
    if (expected.max_slope && facts.steepest.value > *expected.max_slope) {
        return "has a slope of " + fixed(degrees(facts.steepest.value), 1) + " degrees" +
               at_text(facts.steepest.at) + ", expected at most " + fixed(degrees(*expected.max_slope), 1);
    }
    return "";
}

}  // namespace

Finding check_route(const ExpectReachable& expected, const EvaluatorContext& context,
                    std::optional<std::size_t> max_nodes) {
    const FoundRoute found = find_route(expected, context, max_nodes);
    if (!found.route) {
        return no_route(expected, found.why_not);
    }
    return {true,
            expected.mark,
            "a route of " + in_metres(found.route->length()) + " leads to " + expected.to.label + " from " +
                expected.from.label,
            {}};
}

Finding check_route(const ExpectRoute& expected, const EvaluatorContext& context,
                    std::optional<std::size_t> max_nodes) {
    const FoundRoute found = find_route(expected, context, max_nodes);
    if (!found.route) {
        return no_route(expected, found.why_not);
    }
    const RouteFacts facts =
        facts_of(*found.route, context.campus.world, found.settings.strides.body, found.settings.solids);
    const std::string wrong = violation(expected, *found.route, facts);
    return {wrong.empty(),
            expected.mark,
            "the route from " + expected.from.label + " to " + expected.to.label + " " +
                (wrong.empty() ? "is " + in_metres(found.route->length()) + " long" : wrong),
            {}};
}

}  // namespace campuswalk::engine
