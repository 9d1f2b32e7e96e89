#include "config/loader/walk/read_single_expectation.h"

#include <array>
#include <variant>

#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/walk/read_pattern.h"

namespace campuswalk::config {

using namespace engine;

namespace {

constexpr Range kRatio{0.0, 1.0, false, ""};
constexpr Range kRouteWidth{0.0, 3.0, true, "m"};

NamePattern read_name(const CheckedNode& node) {
    return {node.mark(), name_in(node).value_or("*")};
}

void read_event(CheckedMap& map, std::string_view key, EventPattern& event) {
    if (const auto node = map.require(key)) {
        event = read_pattern(*node);
    }
}

void read_glob(CheckedMap& map, std::string_view key, std::string& glob) {
    if (const auto node = map.find(key)) {
        glob = name_in(*node).value_or("*");
    }
}

constexpr int kMaxTimes = 1'000'000'000;

/// The keys `equals`, `at_least` and `at_most` of a map that messages call `what`, as in "'count'". `read`
/// returns a node's number.
template <typename Number, typename Read>
void read_limits(CheckedMap& map, std::string_view what, const Read& read, Limits<Number>& limits) {
    const auto read_one = [&](std::string_view key, std::optional<Number>& limit) {
        if (const auto value = map.find(key)) {
            limit = read(*value);
        }
    };
    read_one("equals", limits.equals);
    read_one("at_least", limits.at_least);
    read_one("at_most", limits.at_most);
    if (map.is_map() && !map.has("equals") && !map.has("at_least") && !map.has("at_most")) {
        map.diagnose("missing-key", std::string(what) + " needs one of equals, at_least, at_most");
    }
    if (limits.at_least && limits.at_most && *limits.at_least > *limits.at_most) {
        map.diagnose_at("at_most", "bad-value", "'at_most' is less than 'at_least'");
    }
}

/// A plain number means `equals`; otherwise a map with those keys and no others.
template <typename Number, typename Read>
Limits<Number> read_either(const CheckedNode& node, const Read& read) {
    Limits<Number> limits;
    if (!node.is_map()) {
        limits.equals = read(node);
        return limits;
    }
    CheckedMap map(node, node.what());
    read_limits(map, node.what(), read, limits);
    map.refuse_other_keys();
    return limits;
}

std::optional<int> read_times(const CheckedNode& node) {
    return node.as_int(0, kMaxTimes);
}

Limits<int> read_times_limits(const CheckedNode& node) {
    return read_either<int>(node, read_times);
}

Limits<double> read_limits(const CheckedNode& node, const Range& range) {
    return read_either<double>(node, [&](const CheckedNode& value) { return value.number(range); });
}

// ---- events ---------------------------------------------------------------------------------------------

PlainExpectation read_sequence(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectSequence sequence;
    sequence.mark = node.mark();
    for (const CheckedNode& item : node.items_or_one("an event")) {
        sequence.events.push_back(read_pattern(item));
    }
    if (sequence.events.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value", "'sequence' needs at least one event");
    }
    return sequence;
}

PlainExpectation read_never(const CheckedNode& node, const WalkNames& /*names*/) {
    return ExpectNever{node.mark(), read_pattern(node)};
}

PlainExpectation read_count(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectCount count;
    count.mark = node.mark();
    CheckedMap map(node, "'count'");
    read_event(map, "event", count.event);
    read_limits(map, "'count'", read_times, count.times);
    map.refuse_other_keys();
    return count;
}

PlainExpectation read_within(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectWithin within;
    within.mark = node.mark();
    CheckedMap map(node, "'within'");
    read_event(map, "after", within.after);
    read_event(map, "event", within.event);
    map.require("seconds");
    map.number("seconds", kSeconds, within.seconds);
    map.refuse_other_keys();
    return within;
}

// ---- pop-ups --------------------------------------------------------------------------------------------

PlainExpectation read_popup(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectPopup popup;
    popup.mark = node.mark();
    if (!node.is_map()) {
        popup.building = read_name(node);
        return popup;
    }
    CheckedMap map(node, "'popup'");
    popup.building.mark = node.mark();
    if (const auto building = map.require("building")) {
        popup.building = read_name(*building);
    }
    read_glob(map, "title", popup.title);
    read_glob(map, "body", popup.body);
    if (const auto times = map.find("times")) {
        popup.times = read_times_limits(*times);
    }
    map.refuse_other_keys();
    return popup;
}

PlainExpectation read_visits(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectVisits visits;
    visits.mark = node.mark();
    const auto read_buildings = [&](const CheckedNode& list) {
        for (const CheckedNode& item : list.items_or_one("a building")) {
            visits.buildings.push_back(read_name(item));
        }
        if (visits.buildings.empty() && (list.is_sequence() || list.is_null())) {
            list.diagnose("bad-value", list.what() + " needs at least one building");
        }
    };
    if (!node.is_map()) {
        read_buildings(node);
        return visits;
    }
    CheckedMap map(node, "'visits'");
    if (const auto buildings = map.find("buildings")) {
        read_buildings(*buildings);
    } else {
        visits.buildings.push_back({node.mark(), "*"});
    }
    map.number("ratio", kRatio, visits.ratio);
    if (!map.has("buildings") && !map.has("ratio")) {
        map.diagnose("missing-key", "'visits' needs buildings, a ratio, or both");
    }
    map.refuse_other_keys();
    return visits;
}

// ---- the path -------------------------------------------------------------------------------------------

/// A place, or a map with `place` and `within`; `read_more` reads the map's other keys.
template <typename Expected, typename ReadMore>
Expected read_at_place(const CheckedNode& node, const WalkNames& names, const ReadMore& read_more) {
    Expected expected;
    expected.mark = node.mark();
    if (!node.is_map()) {
        expected.target = names.campus.target(node);
        return expected;
    }
    CheckedMap map(node, "'" + std::string(Expected::kName) + "'");
    if (const auto place = map.require("place")) {
        expected.target = names.campus.target(*place);
    }
    map.number("within", kPositiveLength, expected.within);
    read_more(map, expected);
    map.refuse_other_keys();
    return expected;
}

PlainExpectation read_reaches(const CheckedNode& node, const WalkNames& names) {
    return read_at_place<ExpectReaches>(node, names, [](CheckedMap&, ExpectReaches&) {});
}

PlainExpectation read_near(const CheckedNode& node, const WalkNames& names) {
    return read_at_place<ExpectNear>(node, names, [](CheckedMap& map, ExpectNear& near) {
        const auto at = map.find("at");
        if (at && !(at->is_scalar() && at->text() == "end")) {
            near.at = read_pattern(*at);
        }
    });
}

PlainExpectation read_duration(const CheckedNode& node, const WalkNames& /*names*/) {
    return ExpectDuration{node.mark(), read_limits(node, kSeconds)};
}

PlainExpectation read_distance(const CheckedNode& node, const WalkNames& /*names*/) {
    return ExpectDistance{node.mark(), read_limits(node, kDistance)};
}

// ---- the body -------------------------------------------------------------------------------------------

PlainExpectation read_no_penetration(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectNoPenetration expected;
    expected.mark = node.mark();
    if (node.is_null()) {
        return expected;
    }
    CheckedMap map(node, "'no_penetration'");
    map.require("tolerance");
    map.number("tolerance", kDistance, expected.tolerance);
    map.refuse_other_keys();
    return expected;
}

PlainExpectation read_grounded(const CheckedNode& node, const WalkNames& /*names*/) {
    constexpr std::array kAlways = {Choice<double>{"always", 1.0}};
    ExpectGrounded grounded;
    grounded.mark = node.mark();
    if (node.is_null()) {
        return grounded;
    }
    if (!node.is_map()) {
        node.choice(kAlways);
        return grounded;
    }
    CheckedMap map(node, "'grounded'");
    map.require("ratio");
    map.number("ratio", kRatio, grounded.ratio);
    map.refuse_other_keys();
    return grounded;
}

PlainExpectation read_blocked_by(const CheckedNode& node, const WalkNames& /*names*/) {
    return ExpectBlockedBy{node.mark(), read_name(node)};
}

PlainExpectation read_stuck(const CheckedNode& node, const WalkNames& /*names*/) {
    ExpectStuck stuck;
    stuck.mark = stuck.by.mark = node.mark();
    if (node.is_null()) {
        return stuck;
    }
    CheckedMap map(node, "'stuck'");
    if (const auto by = map.require("by")) {
        stuck.by = read_name(*by);
    }
    map.refuse_other_keys();
    return stuck;
}

PlainExpectation read_fell(const CheckedNode& node, const WalkNames& /*names*/) {
    if (!node.is_null()) {
        node.diagnose("wrong-type", "'fell' takes no value");
    }
    return ExpectFell{node.mark()};
}

// ---- the campus -----------------------------------------------------------------------------------------

/// The keys `from`, `to` and `avatar`.
template <typename Expected>
void read_passage(CheckedMap& map, const WalkNames& names, Expected& expected) {
    if (const auto from = map.require("from")) {
        expected.from = names.campus.target(*from);
    }
    if (const auto to = map.require("to")) {
        expected.to = names.campus.target(*to);
    }
    if (const auto avatar = map.find("avatar")) {
        expected.avatar = names.avatars.read(*avatar);
    }
}

PlainExpectation read_reachable(const CheckedNode& node, const WalkNames& names) {
    ExpectReachable expected;
    expected.mark = node.mark();
    CheckedMap map(node, "'reachable'");
    read_passage(map, names, expected);
    map.refuse_other_keys();
    return expected;
}

PlainExpectation read_route(const CheckedNode& node, const WalkNames& names) {
    ExpectRoute expected;
    expected.mark = node.mark();
    CheckedMap map(node, "'route'");
    read_passage(map, names, expected);
    map.number("max_length", kPositiveLength, expected.max_length);
    map.number("min_width", kRouteWidth, expected.min_width);
    map.angle("max_slope_deg", kSlope, expected.max_slope);
    map.refuse_other_keys();
    return expected;
}

constexpr std::array kExpectationReaders = {ExpectationReader{"sequence", read_sequence},
                                            ExpectationReader{"never", read_never},
                                            ExpectationReader{"count", read_count},
                                            ExpectationReader{"within", read_within},
                                            ExpectationReader{"popup", read_popup},
                                            ExpectationReader{"visits", read_visits},
                                            ExpectationReader{"reaches", read_reaches},
                                            ExpectationReader{"near", read_near},
                                            ExpectationReader{"duration", read_duration},
                                            ExpectationReader{"distance", read_distance},
                                            ExpectationReader{"grounded", read_grounded, true},
                                            ExpectationReader{"no_penetration", read_no_penetration, true},
                                            ExpectationReader{"stuck", read_stuck, true},
                                            ExpectationReader{"blocked_by", read_blocked_by},
                                            ExpectationReader{"fell", read_fell, true},
                                            ExpectationReader{"reachable", read_reachable},
                                            ExpectationReader{"route", read_route}};
static_assert(kExpectationReaders.size() == std::variant_size_v<PlainExpectation>);

}  // namespace

std::span<const ExpectationReader> expectation_readers() {
    return kExpectationReaders;
}

}  // namespace campuswalk::config
