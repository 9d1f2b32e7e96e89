#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

/// Reads a map with known keys. Look up every key that is allowed, then call `refuse_other_keys`. The setters
/// leave their target unchanged if the key is absent; a wrong value is reported.
class CheckedMap {
public:
    /// Reports a node that isn't a map (wrong-type); then missing keys are not reported as well.
    /// `what` names the map in messages, as in "a collider".
    CheckedMap(const CheckedNode& node, std::string what);

    bool is_map() const { return is_map_; }

    std::optional<CheckedNode> find(std::string_view key);
    /// As `find`; reports an absent key (missing-key).
    std::optional<CheckedNode> require(std::string_view key);
    bool has(std::string_view key) const;
    void diagnose(scene::DiagnosticCode code, std::string message) const {
        node_.diagnose(code, std::move(message));
    }
    /// Reports an error at the key's value, or at the map if the key is absent.
    void diagnose_at(std::string_view key, scene::DiagnosticCode code, std::string message) const;

    void text(std::string_view key, std::string& target);
    void as_bool(std::string_view key, bool& target);
    void as_int(std::string_view key, int min, int max, int& target);
    void number(std::string_view key, const Range& range, double& target);
    void number(std::string_view key, const Range& range, std::optional<double>& target);
    void vector(std::string_view key, const Range& range, Eigen::Vector3d& target);
    void vector(std::string_view key, const Range& range, std::optional<Eigen::Vector3d>& target);
    /// Degrees in the file, radians in `target`.
    void angle(std::string_view key, const Range& degrees, double& target);
    void angle(std::string_view key, const Range& degrees, std::optional<double>& target);

    template <typename Value, std::size_t count>
    void choice(std::string_view key, const std::array<Choice<Value>, count>& choices, Value& target) {
        if (const auto node = find(key)) {
            target = node->choice(choices).value_or(target);
        }
    }

    /// Reports every key that was not looked up (unknown-key).
    void refuse_other_keys() const;

private:
    CheckedNode node_;
    std::string what_;
    bool is_map_ = false;
    std::vector<CheckedNode::Entry> entries_;
    std::vector<std::string> looked_up_;
};

/// Degrees to radians.
double radians(double degrees);

}  // namespace campuswalk::config
