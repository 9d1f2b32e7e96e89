#include "engine/html_report/foreign_json.h"

#include <cmath>

namespace campuswalk::engine {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepest = 64;

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
    if (text.starts_with("\xEF\xBB\xBF")) {
        return std::nullopt;  // browsers refuse it
    }
    bool too_deep = false;
    const auto notice_depth = [&](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/) {
        too_deep = too_deep || depth > kDeepest;
        return !too_deep;
    };
    Json json = Json::parse(text, notice_depth, false);
    return too_deep || json.is_discarded() ? std::nullopt : std::optional(std::move(json));
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
