#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::config {

// How diagnostics quote what the user wrote.

/// 'word', on one line and cut short when long.
std::string in_quotes(std::string_view text);

/// "a, b, c", cut short when there are many.
std::string listed(const std::vector<std::string>& words);

/// scene::did_you_mean, but nothing for words so long that comparing them would take time.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// ` (did you mean 'x'?)` or, when nothing is near, `; known here: a, b, c`.
std::string suggestion_or_list(std::string_view word, const std::vector<std::string>& candidates);

/// A number as a person writes it: no exponent, no trailing zeros.
std::string shown_number(double value);

}  // namespace campuswalk::config
