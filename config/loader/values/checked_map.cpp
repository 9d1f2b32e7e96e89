#include "config/loader/values/checked_map.h"

#include <algorithm>
#include <numbers>

#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

CheckedMap::CheckedMap(const CheckedNode& node, std::string what)
    : node_(node), what_(std::move(what)), is_map_(node.is_map()) {
    if (is_map_) {
        entries_ = node.entries();
    } else {
        node.diagnose("wrong-type", what_ + " must be a map, such as {key: value}");
    }
}

std::optional<CheckedNode> CheckedMap::find(std::string_view key) {
    if (std::ranges::find(looked_up_, key) == looked_up_.end()) {
        looked_up_.emplace_back(key);
    }
    const auto found = std::ranges::find(entries_, key, &CheckedNode::Entry::key);
    return found == entries_.end() ? std::nullopt : std::optional(found->value);
}

std::optional<CheckedNode> CheckedMap::require(std::string_view key) {
    std::optional<CheckedNode> found = find(key);
    if (!found && is_map_) {
        node_.diagnose("missing-key", what_ + " needs the key " + in_quotes(key));
    }
    return found;
}

bool CheckedMap::has(std::string_view key) const {
    return std::ranges::find(entries_, key, &CheckedNode::Entry::key) != entries_.end();
}

void CheckedMap::diagnose_at(std::string_view key, scene::DiagnosticCode code, std::string message) const {
    const auto found = std::ranges::find(entries_, key, &CheckedNode::Entry::key);
    const CheckedNode& at = found == entries_.end() ? node_ : found->value;
    at.diagnose(code, std::move(message));
}

void CheckedMap::text(std::string_view key, std::string& target) {
    if (const auto node = find(key)) {
        target = node->text().value_or(target);
    }
}

void CheckedMap::as_bool(std::string_view key, bool& target) {
    if (const auto node = find(key)) {
        target = node->as_bool().value_or(target);
    }
}

void CheckedMap::as_int(std::string_view key, int min, int max, int& target) {
    if (const auto node = find(key)) {
        target = node->as_int(min, max).value_or(target);
    }
}

void CheckedMap::number(std::string_view key, const Range& range, double& target) {
    if (const auto node = find(key)) {
        target = node->number(range).value_or(target);
    }
}

void CheckedMap::number(std::string_view key, const Range& range, std::optional<double>& target) {
    if (const auto node = find(key)) {
        target = node->number(range);
    }
}

void CheckedMap::vector(std::string_view key, const Range& range, Eigen::Vector3d& target) {
    if (const auto node = find(key)) {
        target = node->vector(range).value_or(target);
    }
}

void CheckedMap::vector(std::string_view key, const Range& range, std::optional<Eigen::Vector3d>& target) {
    if (const auto node = find(key)) {
        target = node->vector(range);
    }
}

void CheckedMap::angle(std::string_view key, const Range& degrees, double& target) {
    std::optional<double> value;
    angle(key, degrees, value);
    target = value.value_or(target);
}

void CheckedMap::angle(std::string_view key, const Range& degrees, std::optional<double>& target) {
    const auto node = find(key);
    if (const auto value = node ? node->number(degrees) : std::nullopt) {
        target = radians(*value);
    }
}

void CheckedMap::refuse_other_keys() const {
    for (const CheckedNode::Entry& entry : entries_) {
        if (is_full(node_.diagnostics())) {
            return;
        }
        if (std::ranges::find(looked_up_, entry.key) == looked_up_.end()) {
            add_diagnostic(node_.diagnostics(), entry.key_mark, "unknown-key",
                           "unknown key " + in_quotes(entry.key) + " in " + what_ +
                               suggestion_or_list(entry.key, looked_up_));
        }
    }
}

}  // namespace campuswalk::config
