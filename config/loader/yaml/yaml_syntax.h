#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace campuswalk::config {

/// What to do about a syntax error, from the parser's own words; those words when nothing better is known.
std::string explained(const std::string& parser_message);

/// Whether the value at `at` starts with a quote that nothing closes. The parser takes the rest of the file
/// for its text without a word. Anchors and tags before the quote are skipped.
bool is_quote_unclosed(std::string_view text, std::size_t at);

}  // namespace campuswalk::config
