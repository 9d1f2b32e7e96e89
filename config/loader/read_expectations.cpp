#include "config/loader/read_expectations.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "config/loader/checked_map.h"
#include "config/loader/ranges.h"
#include "config/loader/single_key.h"
#include "engine/events/event.h"
#include "scene/glob.h"

namespace campuswalk::config {

using engine::EventPattern;
using engine::Expectation;
using engine::ExpectCount;
using engine::ExpectNever;
using engine::ExpectReaches;
using engine::ExpectSequence;

namespace {

/// `KIND OBJECT` or `KIND`; a kind that no event has is a typing mistake.
EventPattern read_pattern(const CheckedNode& node) {
    EventPattern pattern;
    pattern.mark = node.mark();
    std::istringstream words(node.line().value_or(""));
    words >> pattern.kind;
    if (pattern.kind.empty()) {
        return pattern;  // has been complained of
    }
    words >> pattern.object;
    if (std::string more; words >> more) {
        node.complain("bad-value", "an event is written KIND OBJECT, as in 'popup.open library'; " +
                                       in_quotes(more) + " is too much");
    }
    const std::vector<std::string> kinds = engine::event_kind_names();
    const auto known = [&](const std::string& kind) { return scene::glob_matches(pattern.kind, kind); };
    if (std::ranges::none_of(kinds, known)) {
        node.complain("unknown-name", "no event is called " + in_quotes(pattern.kind) +
                                          suggestion_or_list(pattern.kind, kinds));
    }
    return pattern;
}

Expectation read_sequence(const CheckedNode& node, const CampusNames& /*names*/) {
    ExpectSequence sequence;
    sequence.mark = node.mark();
    for (const CheckedNode& item : node.items_or_one("an event")) {
        sequence.events.push_back(read_pattern(item));
    }
    if (sequence.events.empty() && (node.is_sequence() || node.is_null())) {
        node.complain("bad-value", "'sequence' needs at least one event");
    }
    return sequence;
}

Expectation read_never(const CheckedNode& node, const CampusNames& /*names*/) {
    return ExpectNever{node.mark(), read_pattern(node)};
}

Expectation read_count(const CheckedNode& node, const CampusNames& /*names*/) {
    constexpr int kMost = 1'000'000'000;
    ExpectCount count;
    count.mark = node.mark();
    CheckedMap map(node, "'count'");
    if (const auto event = map.require("event")) {
        count.event = read_pattern(*event);
    }
    const auto read_limit = [&](std::string_view key, std::optional<int>& limit) {
        if (const auto value = map.find(key)) {
            limit = value->whole_number(0, kMost);
        }
    };
    read_limit("equals", count.equals);
    read_limit("at_least", count.at_least);
    read_limit("at_most", count.at_most);
    if (map.is_map() && !map.has("equals") && !map.has("at_least") && !map.has("at_most")) {
        node.complain("missing-key", "'count' needs one of equals, at_least, at_most");
    }
    if (count.at_least && count.at_most && *count.at_least > *count.at_most) {
        map.complain_at("at_most", "bad-value", "'at_most' is less than 'at_least'");
    }
    map.refuse_other_keys();
    return count;
}

Expectation read_reaches(const CheckedNode& node, const CampusNames& names) {
    ExpectReaches reaches;
    reaches.mark = node.mark();
    if (!node.is_map()) {
        reaches.target = names.target(node);
        return reaches;
    }
    CheckedMap map(node, "'reaches'");
    if (const auto place = map.require("place")) {
        reaches.target = names.target(*place);
    }
    map.number("within", kLength, reaches.within);
    map.refuse_other_keys();
    return reaches;
}

using ExpectationReader = Expectation (*)(const CheckedNode&, const CampusNames&);
constexpr std::array kExpectations = {
    Choice<ExpectationReader>{"sequence", read_sequence}, Choice<ExpectationReader>{"never", read_never},
    Choice<ExpectationReader>{"count", read_count}, Choice<ExpectationReader>{"reaches", read_reaches}};

}  // namespace

std::vector<Expectation> read_expectations(const CheckedNode& section, const CampusNames& names) {
    std::vector<Expectation> expectations;
    for (const CheckedNode& node : section.items("an expectation")) {
        if (const auto one = single_key(node, "an expectation", kExpectations)) {
            expectations.push_back(one->meaning(one->value, names));
        }
    }
    return expectations;
}

}  // namespace campuswalk::config
