#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// A path as diagnostics show it: as the user gave it, without `.` and `x/..`.
std::string shown_path(const std::filesystem::path& path);

/// Reads a text file for the YAML parser: UTF-8, lines ended by `\n` (a byte order mark and `\r\n` are taken
/// and dropped), no control characters, no tabs before a line's first character, no line that starts with
/// '%' (a directive, which the parser would skip), at most 2 MB.
/// Complains otherwise: missing-file at `asked_at` (where the file was named), too-large and yaml-syntax at
/// the file itself.
std::optional<std::string> read_source(const std::filesystem::path& path, const scene::SourceMark& asked_at,
                                       scene::DiagnosticList& diagnostics);

/// Bytes of the UTF-8 character that starts at `at`, 0 when there is none (overlong forms, surrogates and
/// anything cut short are none).
std::size_t utf8_length(std::string_view text, std::size_t at);

}  // namespace campuswalk::config
