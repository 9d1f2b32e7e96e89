#pragma once

#include <string>
#include <string_view>

#include "scene/base/diagnostic_code.h"

namespace campuswalk::config {

/// The values that a number may have.
struct Range {
    double min = 0.0;
    double max = 0.0;
    bool excludes_min = false;  ///< `min` itself is too small
    std::string_view unit;      ///< for messages: "m", "degrees"; empty for plain numbers
};

/// A number, or why the text isn't a valid one: `code` is wrong-type (not a number at all) or bad-value.
struct ParsedNumber {
    double value = 0.0;
    scene::DiagnosticCode code;  ///< empty if `value` is valid
    std::string message;         ///< follows the key's name: "must be …"
};

/// Reads a decimal number: digits, at most one point, an exponent, a sign. Not accepted: hexadecimal and
/// octal notation, leading zeros (YAML 1.1 reads 010 as eight, YAML 1.2 as ten), infinities, NaN, and what
/// doesn't fit a double.
ParsedNumber parse_number(std::string_view text, const Range& range);

}  // namespace campuswalk::config
