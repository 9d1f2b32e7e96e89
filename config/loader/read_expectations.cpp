#include "config/loader/read_expectations.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "config/loader/checked_map.h"
#include "config/loader/read_single_expectation.h"
#include "config/loader/single_key.h"

namespace campuswalk::config {

using engine::Expectation;
using engine::ExpectLog;
using engine::ExpectNot;
using engine::PlainExpectation;

namespace {

/// Where an expectation stands.
struct Place {
    const CampusNames& names;
    bool in_step = false;
};

using Plain = PlainExpectation (*)(const CheckedNode&, const CampusNames&);
constexpr std::array kPlain = {
    Choice<Plain>{"sequence", read_sequence}, Choice<Plain>{"never", read_never},
    Choice<Plain>{"count", read_count},       Choice<Plain>{"within", read_within},
    Choice<Plain>{"popup", read_popup},       Choice<Plain>{"visits", read_visits},
    Choice<Plain>{"reaches", read_reaches},   Choice<Plain>{"near", read_near},
    Choice<Plain>{"duration", read_duration}, Choice<Plain>{"distance", read_distance},
    Choice<Plain>{"grounded", read_grounded}, Choice<Plain>{"no_penetration", read_no_penetration},
    Choice<Plain>{"stuck", read_stuck},       Choice<Plain>{"blocked_by", read_blocked_by},
    Choice<Plain>{"fell", read_fell}};

/// Those that can stand without a value.
constexpr std::array<std::string_view, 4> kWords = {"grounded", "no_penetration", "stuck", "fell"};

/// A key of the list, or one of those two: null for these.
constexpr auto kAll = [] {
    std::array<Choice<Plain>, kPlain.size() + 2> all;
    std::ranges::copy(kPlain, all.begin());
    all[kPlain.size()] = {"not", nullptr};
    all[kPlain.size() + 1] = {"log", nullptr};
    return all;
}();

/// A word that stands for itself, as if it were a key with nothing behind it.
std::optional<PlainExpectation> read_word(const CheckedNode& node, const CampusNames& names) {
    const std::string word = node.is_scalar() ? node.text().value_or("") : "";
    if (std::ranges::find(kWords, word) == kWords.end()) {
        return std::nullopt;
    }
    const scene::SourceMark mark = node.mark();
    YamlNode nothing;
    nothing.line = mark.line;
    nothing.column = mark.column;
    const CheckedNode value(nothing, "'" + word + "'", mark.file, node.diagnostics());
    return std::ranges::find(kPlain, word, &Choice<Plain>::name)->value(value, names);
}

std::optional<Expectation> read_not(const CheckedNode& node, const CampusNames& names) {
    if (auto word = read_word(node, names)) {
        return ExpectNot{node.mark(), std::move(*word)};
    }
    if (const auto one = single_key(node, "what is not expected", kPlain)) {
        return ExpectNot{node.mark(), one->meaning(one->value, names)};
    }
    return std::nullopt;
}

Expectation read_log(const CheckedNode& node, bool in_step) {
    ExpectLog log;
    log.mark = node.mark();
    if (in_step) {
        node.complain("bad-value", "'log' can only be judged after the walk: put it below its 'expect'");
    }
    CheckedMap map(node, "'log'");
    map.require("golden");
    map.truth("golden", log.golden);
    map.refuse_other_keys();
    return log;
}

std::optional<Expectation> read_expectation(const CheckedNode& node, const Place& place) {
    if (auto word = read_word(node, place.names)) {
        return std::move(*word);
    }
    const auto one = single_key(node, "an expectation", kAll);
    if (!one) {
        return std::nullopt;
    }
    if (one->meaning != nullptr) {
        return one->meaning(one->value, place.names);
    }
    return one->key == "not" ? read_not(one->value, place.names)
                             : std::optional(read_log(one->value, place.in_step));
}

std::vector<Expectation> read_all(const std::vector<CheckedNode>& nodes, const Place& place) {
    std::vector<Expectation> expectations;
    for (const CheckedNode& node : nodes) {
        if (auto expectation = read_expectation(node, place)) {
            expectations.push_back(std::move(*expectation));
        }
    }
    return expectations;
}

}  // namespace

std::vector<Expectation> read_expectations(const CheckedNode& section, const CampusNames& names) {
    return read_all(section.items("an expectation"), {names, false});
}

std::vector<Expectation> read_step_expectations(const CheckedNode& node, const CampusNames& names) {
    if (!node.is_sequence() && !node.is_null()) {
        return read_all({node}, {names, true});
    }
    const std::vector<CheckedNode> nodes = node.items("an expectation");
    if (nodes.empty()) {
        node.complain("bad-value", "'expect' needs at least one expectation");
    }
    return read_all(nodes, {names, true});
}

}  // namespace campuswalk::config
