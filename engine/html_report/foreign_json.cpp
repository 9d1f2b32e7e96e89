#include "engine/html_report/foreign_json.h"

namespace campuswalk::engine {

namespace {

/// Whether brackets are nested more than kDeepest deep. Of text that isn't JSON, it counts at least as deep
/// as a parser gets before it notices.
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

}  // namespace

std::optional<nlohmann::ordered_json> parse_foreign(std::string_view text) {
    if (text.starts_with(kByteOrderMark) || is_nested_deeply(text)) {
        return std::nullopt;
    }
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

}  // namespace campuswalk::engine
