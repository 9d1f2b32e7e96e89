#pragma once

#include <string>
#include <string_view>

namespace campuswalk::engine {

// Names and messages come from users' files and file systems, and may contain anything. Each kind of report
// gets them in a form that can't break it.

/// One line for people: characters that would move a cursor or end the line become `\n`, `\x1b`; bytes that
/// aren't UTF-8 become U+FFFD.
std::string printable(std::string_view text);

/// Characters that XML 1.0 allows; others become U+FFFD. Escaping markup is left to the XML library.
std::string xml_characters(std::string_view text);

/// Valid UTF-8: each byte that isn't becomes U+FFFD.
std::string valid_utf8(std::string_view text);

}  // namespace campuswalk::engine
