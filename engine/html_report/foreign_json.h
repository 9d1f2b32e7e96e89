#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace campuswalk::engine {

// JSON of files that anybody may have written: a report shows what is as expected and leaves the rest out.

/// None for text that isn't JSON, begins with a byte order mark, or is nested more than 64 deep: copying,
/// printing and reading it elsewhere would take as much stack.
std::optional<nlohmann::ordered_json> parse_foreign(std::string_view text);

/// Whether it is an object whose members of these names are strings.
bool has_strings(const nlohmann::ordered_json& json, std::initializer_list<const char*> names);
/// Whether it is an object whose members of these names are finite numbers.
bool has_numbers(const nlohmann::ordered_json& json, std::initializer_list<const char*> names);
/// Whether it is an object whose members of these names are lists of three finite numbers.
bool has_points(const nlohmann::ordered_json& json, std::initializer_list<const char*> names);
/// Whether it is an object whose member of this name is a list of which each item fulfils `is_item`.
template <typename Check>
bool has_list(const nlohmann::ordered_json& json, const char* name, const Check& is_item) {
    const auto list = json.is_object() ? json.find(name) : json.end();
    return list != json.end() && list->is_array() && std::all_of(list->begin(), list->end(), is_item);
}

}  // namespace campuswalk::engine
