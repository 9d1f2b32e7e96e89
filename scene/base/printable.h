#pragma once

#include <string>
#include <string_view>

namespace campuswalk::scene {

// Names and messages come from users' files and file systems, and may contain anything. This is the door that
// they pass before they become part of a line that people or other programs read: in reports, in logs, in
// files and on standard output alike. The layout around them, such as GitHub's `::error`, is the writer's own
// and doesn't pass it.

/// One line of words. Characters that would end the line, move a cursor or reorder the text become `\n`,
/// `\x1b`, `\u202e`, and so do those that look like nothing or like a space (is_unseen() of unicode_words.h);
/// bytes that aren't UTF-8 become U+FFFD. No part of it is a command to a CI machine or a marker in a report:
/// a character of `::` at the line's start (GitHub), of `##[`, `##vso[` and `##teamcity[` (GitHub, Azure,
/// TeamCity) and of `[[ATTACHMENT|` (Jenkins, GitLab), in either case, is written as `\x3a`, `\x23`, `\x5b`.
std::string printable(std::string_view text);

/// The same for JSON text on one line or several, whose strings get JSON's escapes and keep their values.
std::string printable_json(std::string_view json);

}  // namespace campuswalk::scene
