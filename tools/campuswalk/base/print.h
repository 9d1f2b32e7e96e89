#pragma once

#include <string_view>

namespace campuswalk::tools {

// The only way to standard output and standard error, besides reports (log_output.h) and the line that shows
// progress. Names and messages come from strangers' files and may contain anything: what would end a line,
// move a cursor, reorder text or be a CI machine's command is written as an escape.

/// A line to standard output, formatted like printf.
[[gnu::format(printf, 1, 2)]] void print_line(const char* format, ...);

/// Text of the program's own layout to standard output, such as a help topic or JSON (see json_text.h).
void print_lines(std::string_view text);

/// Commands to a CI machine that the user asked for, with their names escaped (engine::github_escaped).
void print_commands(std::string_view text);

/// A line to standard error.
void print_error_line(std::string_view line);

}  // namespace campuswalk::tools
