#pragma once

#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools::bench {

/// One target, and what was measured.
struct Verdict {
    std::string what;
    std::optional<double> value;  ///< none if it wasn't measured
    const char* unit = "";
    bool more_is_better = false;
    double must = 0.0;
    std::optional<double> aim;
    bool holds = true;  ///< at least `must`; false without a value
};

Verdict at_most(std::string what, std::optional<double> value, const char* unit, double must,
                std::optional<double> aim = std::nullopt);
Verdict at_least(std::string what, std::optional<double> value, const char* unit, double must,
                 std::optional<double> aim = std::nullopt);

/// Prints the value and its unit, right-aligned.
void print_value(const Verdict& verdict);

/// Prints a line for each: what it is about, padded to `width` characters, the value as `print` shows it, and
/// whether the target is reached.
void print_verdicts(const std::vector<Verdict>& verdicts, int width = 46,
                    void (*print)(const Verdict& verdict) = print_value);

}  // namespace campuswalk::tools::bench
