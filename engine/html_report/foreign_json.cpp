#include "engine/html_report/foreign_json.h"

#include <cmath>

namespace campuswalk::engine {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepest = 64;

/// Of text that isn't JSON, it counts at least as deep as a parser gets before it notices.
bool is_nested_deeply(std::string_view text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            in_string = !in_string;
        } else if (in_string) {
            i += c == '\\' ? 1 : 0;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepest) {
                return true;
            }
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return false;
}

bool is_number(const Json& json) {
    return json.is_number() && std::isfinite(json.get<double>());
}

template <typename Check>
bool has(const Json& json, std::initializer_list<const char*> names, const Check& check) {
    return json.is_object() && std::all_of(names.begin(), names.end(), [&](const char* name) {
               const auto member = json.find(name);
               return member != json.end() && check(*member);
           });
}

}  // namespace

std::optional<Json> parse_foreign(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF") || is_nested_deeply(text)) {  // browsers refuse the mark
        return std::nullopt;
    }
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

bool has_strings(const Json& json, std::initializer_list<const char*> names) {
    return has(json, names, [](const Json& member) { return member.is_string(); });
}

bool has_numbers(const Json& json, std::initializer_list<const char*> names) {
    return has(json, names, is_number);
}

bool has_points(const Json& json, std::initializer_list<const char*> names) {
    return has(json, names, [](const Json& member) {
        return member.is_array() && member.size() == 3 &&
               std::all_of(member.begin(), member.end(), is_number);
    });
}

}  // namespace campuswalk::engine
