#include "config/loader/walk/read_expectations.h"

#include <array>
#include <string>
#include <utility>

#include "config/loader/values/single_key.h"
#include "config/loader/walk/read_late_expectation.h"
#include "config/loader/walk/read_single_expectation.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

using engine::Expectation;
using engine::ExpectNot;
using engine::ExpectVisible;
using engine::PlainExpectation;

namespace {

/// Where an expectation is written: in the walk's `expect` or in a step's.
struct Place {
    const WalkNames& names;
    bool in_step = false;
};

/// For expectations that can only be evaluated after the walk.
struct LateReader {
    std::string_view name;
    Expectation (*read)(const CheckedNode&) = nullptr;
};
constexpr std::array kLateReaders = {LateReader{"log", read_log},
                                     LateReader{"snapshot", read_expected_snapshot},
                                     LateReader{"visible", read_visible}};

/// An expectation written as a bare word, read as if it were a key with an empty value.
std::optional<PlainExpectation> read_word(const CheckedNode& node, const WalkNames& names) {
    const std::string word = node.is_scalar() ? node.text().value_or("") : "";
    const ExpectationReader* reader = entry_of(expectation_readers(), word);
    if (reader == nullptr || !reader->needs_no_value) {
        return std::nullopt;
    }
    const scene::SourceMark mark = node.mark();
    YamlNode nothing;
    nothing.line = mark.line;
    nothing.column = mark.column;
    return reader->read(CheckedNode(nothing, "'" + word + "'", mark.file, node.diagnostics()), names);
}

void refuse_in_step(const CheckedNode& node, const Place& place, std::string_view key) {
    if (place.in_step) {
        node.diagnose("bad-value",
                      in_quotes(std::string(key)) +
                          " can only be evaluated after the walk; move it to the walk's 'expect'");
    }
}

std::optional<Expectation> read_not(const CheckedNode& node, const Place& place) {
    if (auto word = read_word(node, place.names)) {
        return ExpectNot{node.mark(), std::move(*word)};
    }
    std::vector<std::string> known;
    add_names(expectation_readers(), known);
    known.emplace_back("visible");
    const auto one = single_key(node, "'not'", "not: {popup: lounge}", known);
    if (!one) {
        return std::nullopt;
    }
    if (const ExpectationReader* reader = entry_of(expectation_readers(), one->key)) {
        return ExpectNot{node.mark(), reader->read(one->value, place.names)};
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
    std::vector<std::string> known;
    add_names(expectation_readers(), known);
    known.emplace_back("not");
    add_names(kLateReaders, known);
    const auto one = single_key(node, "an expectation", "- popup: lounge", known);
    if (!one) {
        return std::nullopt;
    }
    if (const ExpectationReader* reader = entry_of(expectation_readers(), one->key)) {
        return reader->read(one->value, place.names);
    }
    if (one->key == "not") {
        return read_not(one->value, place);
    }
    refuse_in_step(one->value, place, one->key);
    return entry_of(kLateReaders, one->key)->read(one->value);
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

std::vector<Expectation> read_expectations(const CheckedNode& section, const WalkNames& names) {
    return read_all(section.items("an expectation"), {names, false});
}

std::vector<Expectation> read_step_expectations(const CheckedNode& node, const WalkNames& names) {
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
