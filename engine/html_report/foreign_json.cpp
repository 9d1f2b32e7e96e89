#include "engine/html_report/foreign_json.h"

#include "scene/base/json_limits.h"

namespace campuswalk::engine {

std::optional<nlohmann::ordered_json> parse_foreign(std::string_view text) {
    if (text.starts_with(kByteOrderMark) || !scene::why_too_complex(text).empty()) {
        return std::nullopt;
    }
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

}  // namespace campuswalk::engine
