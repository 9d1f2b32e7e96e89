#include "engine/html_report/walk_row.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "engine/report/result_text.h"

namespace campuswalk::engine {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostMessage = 300;  // bytes

double to_a_thousandth(double value) {
    return std::floor(value * 1000.0 + 0.5) / 1000.0;
}

/// What a list shows of a walk that didn't pass.
std::string message_of(const WalkResult& result) {
    return !result.failures.empty()      ? result.failures.front().message
           : !result.diagnostics.empty() ? to_string(result.diagnostics.front())
                                         : verdict_in_words(result);
}

}  // namespace

std::string shortened(const std::string& text, std::size_t most) {
    if (text.size() <= most) {
        return text;
    }
    constexpr std::string_view kDots = "…";
    std::size_t end = most - kDots.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
        --end;  // a byte within a character
    }
    return text.substr(0, end) + std::string(kDots);
}

std::string open_walk_row(const WalkResult& result, const WalkPlacement& placement) {
    const Json row = {{"id", result.id},
                      {"file", result.file},
                      {"name", result.name},
                      {"project", result.project},
                      {"repetition", result.repetition},
                      {"tags", result.tags},
                      {"outcome", std::string(name_of(result.outcome))},
                      {"expected_to_fail", result.expected_to_fail},
                      {"status_reason", result.status_reason},
                      {"seconds", to_a_thousandth(seconds_of(result))},
                      {"ticks", result.ticks},
                      {"distance", to_a_thousandth(result.distance)},
                      {"campus", placement.campus},
                      {"thumbnail", placement.thumbnail},
                      {"message", shortened(message_of(result), kMostMessage)},
                      {"code", result.failures.empty() ? "" : result.failures.front().code},
                      {"plan", placement.plan}};
    std::string text = row.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.pop_back();
    return text;
}

}  // namespace campuswalk::engine
