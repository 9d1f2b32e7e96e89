#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace campuswalk::config {

/// A syntax error in our words, with what to do about it; the parser's own words if we have no others.
std::string explained(const std::string& parser_message);

/// Whether the value at `at` starts with a quote that is never closed; the parser silently takes the rest of
/// the file as its text. Anchors and tags before the quote are skipped.
bool is_quote_unclosed(std::string_view text, std::size_t at);

}  // namespace campuswalk::config
