#include "config/loader/read_expectations.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "config/loader/read_late_expectation.h"
#include "config/loader/read_single_expectation.h"
#include "config/loader/single_key.h"

namespace campuswalk::config {

using engine::Expectation;
using engine::ExpectNot;
using engine::ExpectVisible;
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

/// Those that can be judged only after the walk.
using Late = Expectation (*)(const CheckedNode&);
constexpr std::array kLate = {Choice<Late>{"log", read_log}, Choice<Late>{"snapshot", read_expected_snapshot},
                              Choice<Late>{"visible", read_visible}};

/// What a key stands for: one of these, or, with none, `not`.
struct Meaning {
    Plain plain = nullptr;
    Late late = nullptr;
};

constexpr auto kAll = [] {
    std::array<Choice<Meaning>, kPlain.size() + 1 + kLate.size()> all;
    std::size_t next = 0;
    for (const Choice<Plain>& plain : kPlain) {
        all[next++] = {plain.name, {plain.value, nullptr}};
    }
    all[next++] = {"not", {}};
    for (const Choice<Late>& late : kLate) {
        all[next++] = {late.name, {nullptr, late.value}};
    }
    return all;
}();

/// What can be denied: the plain ones, and `visible`, which is none of them.
constexpr auto kDeniable = [] {
    std::array<Choice<Plain>, kPlain.size() + 1> all;
    std::ranges::copy(kPlain, all.begin());
    all[kPlain.size()] = {"visible", nullptr};
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

void refuse_in_step(const CheckedNode& node, const Place& place, std::string_view key) {
    if (place.in_step) {
        node.diagnose("bad-value", in_quotes(std::string(key)) +
                                       " can only be judged after the walk: put it below its 'expect'");
    }
}

std::optional<Expectation> read_not(const CheckedNode& node, const Place& place) {
    if (auto word = read_word(node, place.names)) {
        return ExpectNot{node.mark(), std::move(*word)};
    }
    const auto one = single_key(node, "what is not expected", kDeniable);
    if (!one) {
        return std::nullopt;
    }
    if (one->meaning != nullptr) {
        return ExpectNot{node.mark(), one->meaning(one->value, place.names)};
    }
    refuse_in_step(one->value, place, one->key);
    ExpectVisible visible = std::get<ExpectVisible>(read_visible(one->value));
    visible.negated = true;
    return visible;
}

std::optional<Expectation> read_expectation(const CheckedNode& node, const Place& place) {
    if (auto word = read_word(node, place.names)) {
        return std::move(*word);
    }
    const auto one = single_key(node, "an expectation", kAll);
    if (!one) {
        return std::nullopt;
    }
    if (one->meaning.plain != nullptr) {
        return one->meaning.plain(one->value, place.names);
    }
    if (one->meaning.late == nullptr) {
        return read_not(one->value, place);
    }
    refuse_in_step(one->value, place, one->key);
    return one->meaning.late(one->value);
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
        node.diagnose("bad-value", "'expect' needs at least one expectation");
    }
    return read_all(nodes, {names, true});
}

}  // namespace campuswalk::config
