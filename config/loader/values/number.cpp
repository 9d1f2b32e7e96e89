#include "config/loader/values/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "config/loader/yaml/wording.h"
#include "scene/base/ascii.h"

namespace campuswalk::config {

namespace {

/// Infinity and NaN as YAML, C and Python spell them.
bool is_not_finite(std::string_view unsigned_text) {
    const std::string word = scene::to_lower(std::string(unsigned_text));
    constexpr std::array<std::string_view, 5> kWords = {".inf", ".nan", "inf", "nan", "infinity"};
    return std::ranges::find(kWords, word) != kWords.end();
}

std::string shown_range(const Range& range) {
    const std::string unit = range.unit.empty() ? "" : " " + std::string(range.unit);
    const std::string max = shown_number(range.max) + unit;
    if (range.excludes_min) {
        return "more than " + shown_number(range.min) + " and at most " + max;
    }
    return "from " + shown_number(range.min) + " to " + max;
}

}  // namespace

ParsedNumber parse_number(std::string_view text, const Range& range) {
    const bool negative = text.starts_with('-');
    const std::string_view digits = negative || text.starts_with('+') ? text.substr(1) : text;
    if (is_not_finite(digits)) {
        return {0.0, "bad-value", "must be finite, not " + in_quotes(text)};
    }
    const bool starts_well =
        !digits.empty() && (scene::is_digit(digits[0]) || (digits[0] == '.' && digits.size() > 1));
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general);
    if (!starts_well || error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
        return {0.0, "wrong-type", "must be a number, not " + in_quotes(text)};
    }
    if (error == std::errc::result_out_of_range) {
        return {0.0, "bad-value", "must be a number that fits 64 bits, not " + in_quotes(text)};
    }
    if (digits.size() > 1 && digits[0] == '0' && scene::is_digit(digits[1])) {
        return {0.0, "bad-value",
                "must not start with a zero (some parsers read it as octal), as in " + in_quotes(text)};
    }
    value = negative ? -value : value;
    if (value < range.min || value > range.max || (range.excludes_min && value == range.min)) {
        return {0.0, "bad-value", "must be " + shown_range(range) + ", not " + in_quotes(text)};
    }
    return {value, {}, ""};
}

}  // namespace campuswalk::config
