#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace campuswalk::engine {

// JSON of files that anybody may have written: a report shows what is as expected and leaves the rest out.

/// Whether brackets are nested more than 64 deep: copying, printing and reading that elsewhere would take as
/// much stack. Of text that isn't JSON, it counts at least as deep as a parser gets before it notices.
bool is_nested_deeply(std::string_view text);

/// None for text that isn't JSON, begins with a byte order mark, or is nested deeply. `Json` is
/// nlohmann::ordered_json for what is written again; nlohmann::json is faster to read, as it moves the
/// members of objects that grow and doesn't copy them.
template <typename Json>
std::optional<Json> parse_foreign(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF") || is_nested_deeply(text)) {  // browsers refuse the mark
        return std::nullopt;
    }
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

template <typename Json>
bool is_finite_number(const Json& json) {
    return json.is_number() && std::isfinite(json.template get<double>());
}

/// Whether it is an object whose members of these names fulfil `check`.
template <typename Json, typename Check>
bool has_all(const Json& json, std::initializer_list<const char*> names, const Check& check) {
    return json.is_object() && std::all_of(names.begin(), names.end(), [&](const char* name) {
               const auto member = json.find(name);
               return member != json.end() && check(*member);
           });
}

template <typename Json>
bool has_strings(const Json& json, std::initializer_list<const char*> names) {
    return has_all(json, names, [](const Json& member) { return member.is_string(); });
}

template <typename Json>
bool has_numbers(const Json& json, std::initializer_list<const char*> names) {
    return has_all(json, names, is_finite_number<Json>);
}

/// Lists of three finite numbers.
template <typename Json>
bool has_points(const Json& json, std::initializer_list<const char*> names) {
    return has_all(json, names, [](const Json& member) {
        return member.is_array() && member.size() == 3 &&
               std::all_of(member.begin(), member.end(), is_finite_number<Json>);
    });
}

/// Whether it is an object whose member of this name is a list of which each item fulfils `is_item`.
template <typename Json, typename Check>
bool has_list(const Json& json, const char* name, const Check& is_item) {
    return has_all(json, {name}, [&](const Json& list) {
        return list.is_array() && std::all_of(list.begin(), list.end(), is_item);
    });
}

}  // namespace campuswalk::engine
