#pragma once

#include <map>
#include <optional>
#include <string>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

// Names appear in logs, in patterns and, for snapshots, in file names; the same form is required of all.

/// A kebab-case word, as in "main-gate"; reports anything else (bad-value).
std::optional<std::string> kebab_name(const CheckedNode& node);
/// Kebab-case words joined by '/', as in "library/door".
std::optional<std::string> kebab_path(const CheckedNode& node);

/// Reports a map's key that isn't a kebab-case word.
void check_kebab_key(const CheckedNode::Entry& entry);

/// Reports duplicate names (duplicate-name), at the second occurrence.
class UniqueNames {
public:
    /// `thing` is what the names belong to, as in "building".
    explicit UniqueNames(std::string thing) : thing_(std::move(thing)) {}
    /// An empty name is ignored: it has already been reported.
    void add(const std::string& name, const CheckedNode& at);

private:
    std::string thing_;
    std::map<std::string, scene::SourceMark> marks_;
};

}  // namespace campuswalk::config
