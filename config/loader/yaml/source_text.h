#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// A path as diagnostics show it: as the user gave it, without `.` and `x/..`.
std::string shown_path(const std::filesystem::path& path);

/// Bytes that a file may have: the map of a town makes some.
inline constexpr std::uintmax_t kMaxSourceBytes = 8'000'000;

/// The bytes of a file of at most 8 MB. Reports missing-file at `named_at` (where the file is named) and
/// too-large in the file itself.
std::optional<std::string> read_bytes(const std::filesystem::path& path, const scene::SourceMark& named_at,
                                      scene::DiagnosticList& diagnostics);

/// Reads a text file for the YAML parser: UTF-8, lines ended by `\n` (a byte order mark and the `\r` of
/// `\r\n` are dropped), no control characters, no tabs before a line's first character, no line that starts
/// with '%' (a directive, which the parser would skip), at most 8 MB. Reports anything else: as read_bytes,
/// and yaml-syntax in the file itself.
std::optional<std::string> read_source(const std::filesystem::path& path, const scene::SourceMark& named_at,
                                       scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
