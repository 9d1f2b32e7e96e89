#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

// Names appear in logs and in patterns, ids in any script (scene/base/unicode_words.h); those of profiles and
// snapshots are also file names, and those of tags and fields words of options: they are kebab-case.

inline constexpr std::size_t kMaxNameBytes = 200;

/// A kebab-case word, as in "main-gate"; reports anything else (bad-value).
std::optional<std::string> kebab_name(const CheckedNode& node);
/// Reports a map's key that isn't a kebab-case word.
void check_kebab_key(const CheckedNode::Entry& entry);

/// An id in normalization form C; reports what can't be one.
std::optional<std::string> id_word(const CheckedNode& node);
/// Ids joined by '/', as in "library/door".
std::optional<std::string> id_path(const CheckedNode& node);
/// A map's key as an id; reports one that can't be.
std::string id_key(const CheckedNode::Entry& entry);

/// What refers to an id, or a pattern of ids: a line of text in normalization form C.
std::optional<std::string> name_in(const CheckedNode& node);

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
