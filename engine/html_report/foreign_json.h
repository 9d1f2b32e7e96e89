#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace campuswalk::engine {

// JSON of files that anybody may have written: a report shows what is as expected and leaves the rest out.

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // browsers refuse it before JSON

/// None for text that isn't JSON, begins with a byte order mark, or is too complex (see
/// scene/base/json_limits.h).
std::optional<nlohmann::ordered_json> parse_foreign(std::string_view text);

inline bool is_finite_number(const nlohmann::ordered_json& json) {
    return json.is_number() && std::isfinite(json.get<double>());
}

/// Whether it is an object whose members of these names fulfil `check`.
template <typename Check>
bool has_all(const nlohmann::ordered_json& json, std::initializer_list<const char*> names,
             const Check& check) {
    return json.is_object() && std::all_of(names.begin(), names.end(), [&](const char* name) {
               const auto member = json.find(name);
               return member != json.end() && check(*member);
           });
}

inline bool has_strings(const nlohmann::ordered_json& json, std::initializer_list<const char*> names) {
    return has_all(json, names, [](const nlohmann::ordered_json& member) { return member.is_string(); });
}

inline bool has_numbers(const nlohmann::ordered_json& json, std::initializer_list<const char*> names) {
    return has_all(json, names, is_finite_number);
}

/// Lists of three finite numbers.
inline bool has_points(const nlohmann::ordered_json& json, std::initializer_list<const char*> names) {
    return has_all(json, names, [](const nlohmann::ordered_json& member) {
        return member.is_array() && member.size() == 3 &&
               std::all_of(member.begin(), member.end(), is_finite_number);
    });
}

/// Whether it is an object whose member of this name is a list of which each item fulfils `is_item`.
template <typename Check>
bool has_list(const nlohmann::ordered_json& json, const char* name, const Check& is_item) {
    return has_all(json, {name}, [&](const nlohmann::ordered_json& list) {
        return list.is_array() && std::all_of(list.begin(), list.end(), is_item);
    });
}

}  // namespace campuswalk::engine
