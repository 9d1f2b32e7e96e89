#pragma once

#include <string>
#include <string_view>

namespace campuswalk::engine {

// Names and messages come from users' files and file systems: they may hold anything. Each kind of report
// gets them in a form that can't break it.

/// One line for people: what would move a cursor or end the line is spelled `\n`, `\x1b`; bytes that are no
/// UTF-8 become U+FFFD.
std::string printable(std::string_view text);

/// What XML 1.0 can hold: anything else becomes U+FFFD. Markup is left to the library that writes it.
std::string xml_characters(std::string_view text);

/// Valid UTF-8: bytes that are none become U+FFFD, one each.
std::string valid_utf8(std::string_view text);

}  // namespace campuswalk::engine
