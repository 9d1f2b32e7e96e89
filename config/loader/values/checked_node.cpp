#include "config/loader/values/checked_node.h"

#include <algorithm>

#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

using scene::SourceMark;

namespace {

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F;
}

/// What messages call a node.
std::string_view kind_name(const YamlNode& node) {
    switch (node.kind) {
        case YamlNode::Kind::null:
            return "nothing";
        case YamlNode::Kind::scalar:
            return node.quoted ? "quoted text" : "a single value";
        case YamlNode::Kind::sequence:
            return "a list";
        case YamlNode::Kind::map:
            return "a map";
    }
    return "";
}

}  // namespace

void CheckedNode::diagnose(scene::DiagnosticCode code, std::string message) const {
    add_diagnostic(*diagnostics_, mark(), code, std::move(message));
}

bool CheckedNode::require_scalar(std::string_view expected) const {
    if (is_scalar()) {
        return true;
    }
    diagnose("wrong-type", is_null() ? what_ + " is empty; it must be " + std::string(expected)
                                     : what_ + " must be " + std::string(expected) + ", not " +
                                           std::string(kind_name(*node_)));
    return false;
}

std::optional<std::string> CheckedNode::text() const {
    if (!require_scalar("text")) {
        return std::nullopt;
    }
    if (std::ranges::any_of(node_->text, is_control)) {
        diagnose("bad-value", what_ + " must not contain control characters");
        return std::nullopt;
    }
    return node_->text;
}

std::optional<std::string> CheckedNode::line() const {
    std::optional<std::string> value = text();
    if (value && (value->empty() || value->find_first_of("\n\t") != std::string::npos)) {
        diagnose("bad-value", what_ + " must be a single line of text and not empty");
        return std::nullopt;
    }
    return value;
}

std::optional<double> CheckedNode::number(const Range& range) const {
    if (!require_scalar("a number")) {
        return std::nullopt;
    }
    if (node_->quoted) {
        diagnose("wrong-type",
                 what_ + " must be a number; remove the quotes around " + in_quotes(node_->text));
        return std::nullopt;
    }
    const ParsedNumber parsed = parse_number(node_->text, range);
    if (!parsed.code.empty()) {
        diagnose(parsed.code, what_ + " " + parsed.message);
        return std::nullopt;
    }
    return parsed.value;
}

std::optional<int> CheckedNode::as_int(int min, int max) const {
    const auto value = number({static_cast<double>(min), static_cast<double>(max), false, ""});
    if (!value) {
        return std::nullopt;
    }
    const auto whole = static_cast<int>(*value);
    if (static_cast<double>(whole) != *value) {
        diagnose("bad-value", what_ + " must be a whole number, not " + in_quotes(node_->text));
        return std::nullopt;
    }
    return whole;
}

std::optional<bool> CheckedNode::as_bool() const {
    if (!require_scalar("true or false")) {
        return std::nullopt;
    }
    if (!node_->quoted && (node_->text == "true" || node_->text == "false")) {
        return node_->text == "true";
    }
    diagnose("wrong-type", what_ + " must be true or false, not " + in_quotes(node_->text) +
                               (node_->quoted ? " in quotes" : ""));
    return std::nullopt;
}

/// Fills `value` from a list of as many numbers. Reports anything else, saying that `shape` is needed, and
/// returns false.
bool CheckedNode::numbers(const Range& range, std::span<double> value, const char* shape) const {
    if (!is_sequence() || node_->items.size() != value.size()) {
        diagnose("wrong-type", what_ + " must be " + shape);
        return false;
    }
    bool valid = true;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto number = child(*node_->items[i], what_).number(range);
        value[i] = number.value_or(0.0);
        valid = valid && number;
    }
    return valid;
}

std::optional<Eigen::Vector3d> CheckedNode::vector(const Range& range) const {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    const bool valid = numbers(range, {value.data(), 3}, "three numbers, as in [0, 1.5, -2]");
    return valid ? std::optional(value) : std::nullopt;
}

std::optional<Eigen::Vector4d> CheckedNode::vector4(const Range& range) const {
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    const bool valid = numbers(range, {value.data(), 4}, "four numbers, as in [0, 0.7071, 0, 0.7071]");
    return valid ? std::optional(value) : std::nullopt;
}

std::optional<std::size_t> CheckedNode::one_of(const std::vector<std::string>& names) const {
    if (!require_scalar("one of " + listed(names))) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(names, node_->text);
    if (found == names.end()) {
        diagnose("bad-value", what_ + " must be one of " + listed(names) + ", not " + in_quotes(node_->text) +
                                  suggestion(node_->text, names));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - names.begin());
}

std::vector<CheckedNode> CheckedNode::items(const std::string& what) const {
    std::vector<CheckedNode> nodes;
    if (!is_sequence() && !is_null()) {
        diagnose("wrong-type", what_ + " must be a list, not " + std::string(kind_name(*node_)));
    }
    for (const auto& item : node_->items) {
        nodes.push_back(child(*item, what));
    }
    return nodes;
}

std::vector<CheckedNode> CheckedNode::items_or_one(const std::string& what) const {
    if (is_scalar()) {
        return {child(*node_, what)};
    }
    if (is_map()) {
        diagnose("wrong-type", what_ + " must be a single value or a list, not a map");
        return {};
    }
    return items(what);
}

std::vector<CheckedNode::Entry> CheckedNode::entries() const {
    std::vector<Entry> list;
    if (!is_map() && !is_null()) {
        diagnose("wrong-type", what_ + " must be a map, not " + std::string(kind_name(*node_)));
    }
    for (const YamlNode::Entry& entry : node_->entries) {
        list.push_back({entry.key, SourceMark{*file_, entry.line, entry.column},
                        child(*entry.value, in_quotes(entry.key))});
    }
    return list;
}

}  // namespace campuswalk::config
