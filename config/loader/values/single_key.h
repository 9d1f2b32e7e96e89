#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

/// A list entry whose only key says what it is, as in `- wait: 2`.
struct SingleKey {
    std::string key;
    CheckedNode value;
};

/// Reports an entry that isn't a map, has more than one key, or an unknown one. `what` names such an entry in
/// messages, as in "a step"; `example` shows how to write one.
std::optional<SingleKey> single_key(const CheckedNode& node, const std::string& what,
                                    std::string_view example, const std::vector<std::string>& known);

/// The table's entry with that name, or null.
template <typename Table>
auto entry_of(const Table& table, std::string_view name) -> decltype(&*std::begin(table)) {
    for (const auto& entry : table) {
        if (entry.name == name) {
            return &entry;
        }
    }
    return nullptr;
}

/// Appends the names of a table's entries to `names`.
template <typename Table>
void add_names(const Table& table, std::vector<std::string>& names) {
    for (const auto& entry : table) {
        names.emplace_back(entry.name);
    }
}

}  // namespace campuswalk::config
