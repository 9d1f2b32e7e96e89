#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace campuswalk::config {

/// What may stand in a number's place.
struct Range {
    double least = 0.0;
    double most = 0.0;
    bool above_least = false;  ///< `least` itself is too small
    std::string_view unit;     ///< for messages: "m", "degrees"; empty for plain numbers
};

/// A number or why it is none: `code` is wrong-type (not a number at all) or bad-value.
struct ParsedNumber {
    double value = 0.0;
    std::string code;     ///< empty: `value` holds
    std::string message;  ///< follows the key's name: "must be …"
};

/// Reads a decimal number: digits, at most one point, an exponent, a sign. Not taken: hexadecimal and octal
/// spellings, leading zeros (YAML 1.1 reads 010 as eight, YAML 1.2 as ten), infinities, NaN, what doesn't fit
/// a double.
ParsedNumber parse_number(std::string_view text, const Range& range);

}  // namespace campuswalk::config
