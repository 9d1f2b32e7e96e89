#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

/// An entry of a list whose only key says what it is, as in `- wait: 2`.
struct SingleKey {
    std::string key;
    CheckedNode value;
};

/// Reports an entry that is no map, has more than one key, or none of the known ones. `what` names such an
/// entry in messages, as in "a step"; `example` shows how one is written.
std::optional<SingleKey> single_key(const CheckedNode& node, const std::string& what,
                                    std::string_view example, const std::vector<std::string>& known);

/// The table's entry of that name; null without one.
template <typename Table>
auto entry_of(const Table& table, std::string_view name) -> decltype(&*std::begin(table)) {
    for (const auto& entry : table) {
        if (entry.name == name) {
            return &entry;
        }
    }
    return nullptr;
}

/// Adds the names of a table's entries.
template <typename Table>
void add_names(const Table& table, std::vector<std::string>& names) {
    for (const auto& entry : table) {
        names.emplace_back(entry.name);
    }
}

}  // namespace campuswalk::config
