#pragma once

#include <map>
#include <optional>
#include <string>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

// Names stand in logs, in patterns and, for snapshots, in file names: one spelling for all of them.

/// A kebab-case word, as in "main-gate"; complains (bad-value) otherwise.
std::optional<std::string> kebab_name(const CheckedNode& node);
/// Kebab-case words joined by '/', as in "library/door".
std::optional<std::string> kebab_path(const CheckedNode& node);

/// The same word as a key of a map.
void check_kebab_key(const CheckedNode::Entry& entry);

/// Keeps names apart: complains (duplicate-name) at the second of two equal ones.
class UniqueNames {
public:
    /// `thing` is what the names belong to, as in "building".
    explicit UniqueNames(std::string thing) : thing_(std::move(thing)) {}
    /// An empty name is one that has been complained of.
    void add(const std::string& name, const CheckedNode& at);

private:
    std::string thing_;
    std::map<std::string, scene::SourceMark> marks_;
};

}  // namespace campuswalk::config
