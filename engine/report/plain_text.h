#pragma once

#include <string>
#include <string_view>

namespace campuswalk::engine {

// Names and messages come from users' files and file systems, and may contain anything. Each kind of report
// gets them in a form that can't break it.

/// One line for people: characters that would end the line, move a cursor or reorder the text (see
/// scene::controls_display) become `\n`, `\x1b`, `\u202e`; bytes that aren't UTF-8 become U+FFFD.
std::string printable(std::string_view text);

/// The same for JSON text on one line or several, whose strings get JSON's escapes and keep their values. No
/// line is a command to a CI machine.
std::string printable_json(std::string_view json);

/// Text of which no line is taken for a command by a CI machine: GitHub obeys lines that begin with `::`
/// after any spaces, and `##[`, Azure `##vso[`, wherever they are. A character of these is written as `\x3a`,
/// `\x23`.
std::string without_ci_commands(std::string_view text);

/// The message of a command to GitHub; in its properties, colons and commas are escaped too. Lines stay
/// apart.
std::string github_escaped(std::string_view text, bool in_property);

/// Characters that XML 1.0 allows; others become U+FFFD. Escaping markup is left to the XML library.
std::string xml_characters(std::string_view text);

/// Valid UTF-8: each byte that isn't becomes U+FFFD.
std::string valid_utf8(std::string_view text);

}  // namespace campuswalk::engine
