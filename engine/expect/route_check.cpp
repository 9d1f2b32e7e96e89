#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/events/decimals.h"
#include "engine/expect/route_evaluators.h"
#include "engine/walkspace/route/campus_route.h"
#include "engine/walkspace/route/route_facts.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A route, or why there is none.
struct FoundRoute {
    std::optional<Route> route;
    Reason why_not;
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
        found.why_not = {.kind = ReasonKind::does_not_fit, .name = expected.from.label};
        return found;
    }
    auto answer = route_or_reason(context.campus, found.settings, {*body, {expected.to}});
    if (auto* route = std::get_if<Route>(&answer)) {
        found.route = std::move(*route);
    } else {
        found.why_not = std::get<Reason>(std::move(answer));
    }
    return found;
}

template <typename Expected>
Finding no_route(const Expected& expected, const Reason& why) {
    const std::string there = expected.to.label + " from " + expected.from.label + ": " + text_of(why);
    Finding finding{false, expected.mark, "no route leads to " + there, {}};
    finding.reason = why;
    if (is_unsearched(why)) {
        finding.lack = kRouteUnknown;
        finding.message = "it isn't known whether a route leads to " + there;
    }
    return finding;
}

std::string at_text(const Vec3& p) {
    return " at " + coordinates_text(p);
}

/// Something about a route that isn't as expected.
struct Violation {
    std::string text;
    std::string expected;
    std::optional<Reason> reason = {};
};

/// The first, if not all is as expected.
std::optional<Violation> violation(const ExpectRoute& expected, const Route& route, const RouteFacts& facts) {
    if (expected.max_length && route.length() > *expected.max_length) {
        return Violation{"is " + in_metres(route.length()) + " long",
                         "at most " + in_metres(*expected.max_length)};
    }
    if (expected.min_width && facts.narrowest && facts.narrowest->value < *expected.min_width) {
        const double width = facts.narrowest->value;
        return Violation{"is " + in_metres(width) + " wide" + at_text(facts.narrowest->at),
                         "at least " + in_metres(*expected.min_width),
                         Reason{.kind = ReasonKind::opening,
                                .at = facts.narrowest->at,
                                .measured = width,
                                .allowed = expected.min_width}};
    }
    if (expected.max_slope && facts.steepest.value > *expected.max_slope) {
        const double slope_deg = degrees(facts.steepest.value);
        const double most_deg = degrees(*expected.max_slope);
        return Violation{"has a slope of " + fixed(slope_deg, 1) + " degrees" + at_text(facts.steepest.at),
                         "at most " + fixed(most_deg, 1),
                         Reason{.kind = ReasonKind::slope,
                                .at = facts.steepest.at,
                                .measured = slope_deg,
                                .allowed = most_deg}};
    }
    return std::nullopt;
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
    const std::optional<Violation> wrong = violation(expected, *found.route, facts);
    Finding finding{!wrong,
                    expected.mark,
                    "the route from " + expected.from.label + " to " + expected.to.label + " " +
                        (wrong ? wrong->text : "is " + in_metres(found.route->length()) + " long"),
                    {}};
    if (wrong) {
        finding.expected = wrong->expected;
        finding.reason = wrong->reason;
    }
    return finding;
}

}  // namespace campuswalk::engine
