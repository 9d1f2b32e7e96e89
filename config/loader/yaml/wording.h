#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::config {

// How diagnostics quote what the user wrote.

/// 'word', on one line and truncated if long.
std::string in_quotes(std::string_view text);

/// "a, b, c", truncated if there are many.
std::string listed(const std::vector<std::string>& words);

/// scene::did_you_mean, but empty if the word is so long, or the candidates so many, that comparing is slow.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// ` (did you mean 'x'?)` or, if nothing is similar, `; known here: a, b, c`.
std::string suggestion_or_list(std::string_view word, const std::vector<std::string>& candidates);

/// A number as a person writes it: no exponent, no trailing zeros.
std::string shown_number(double value);

}  // namespace campuswalk::config
