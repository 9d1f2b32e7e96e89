#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "engine/expect/failure.h"

namespace campuswalk::tools {

/// Which of the files that runs are compared with are written (`--update-snapshots`).
enum class UpdateSnapshots {
    all,      ///< every one, anew
    changed,  ///< missing ones, and those that differ
    missing,  ///< those that aren't there yet
    none,     ///< a missing one is a failure
};

/// The modes by their names on the command line.
const std::map<std::string, UpdateSnapshots>& update_modes();

/// What comparing a run with a golden log gave.
struct GoldenCheck {
    /// The log is another one, or is missing; code "log". Its mark is left to the caller.
    std::optional<engine::Failure> failure;
    /// The file that was written, as the walk file's path leads to it; empty when none was.
    std::filesystem::path written;
    /// The file that would have been written, had the walk not failed; likewise.
    std::filesystem::path withheld;
};

/// `NAME.walk.yaml-snapshots/[PROJECT-]FILE` beside the walk file: where what runs are compared with is kept.
std::filesystem::path cached_file(const std::filesystem::path& walk_file, const std::string& project,
                                  const std::string& file);

/// That of the log, `log.jsonl`.
std::filesystem::path golden_log_file(const std::filesystem::path& walk_file, const std::string& project);

/// Compares a run's log, as engine::JsonLines gives it, with the walk's golden one. Verdicts don't count:
/// what is expected of a walk doesn't change where it goes. Nothing is written of a walk that `fails` as far
/// as is known: what a golden log holds must have been right once. A file is written whole or not at all, and
/// processes may do so at the same time. Throws std::runtime_error when it can't be read or written.
GoldenCheck check_golden(const std::filesystem::path& walk_file, const std::string& project,
                         std::span<const std::string> lines, UpdateSnapshots mode, bool fails);

}  // namespace campuswalk::tools
