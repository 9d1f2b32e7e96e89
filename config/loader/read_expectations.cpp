#include "config/loader/read_expectations.h"

#include <array>

#include "config/loader/checked_map.h"
#include "config/loader/ranges.h"
#include "config/loader/read_pattern.h"
#include "config/loader/single_key.h"

namespace campuswalk::config {

using engine::Expectation;
using engine::ExpectCount;
using engine::ExpectNever;
using engine::ExpectReaches;
using engine::ExpectSequence;

namespace {

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
