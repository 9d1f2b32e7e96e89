#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "engine/expect/failure.h"

namespace campuswalk::tools {

/// Which of the references that runs are compared with are written (`--update-snapshots`).
enum class UpdateSnapshots {
    all,      ///< all of them
    changed,  ///< missing ones and those that differ
    missing,  ///< only missing ones
    none,     ///< none; a missing one is a failure
};

/// The modes by their names on the command line.
const std::map<std::string, UpdateSnapshots>& update_modes();

/// The result of comparing a run with a golden log.
struct GoldenCheck {
    /// The log differs or the golden one is missing; code "log". The caller sets the mark.
    std::optional<engine::Failure> failure;
    /// The file that was written, relative like the walk file; empty when none was.
    std::filesystem::path written;
    /// The file that would have been written if the walk hadn't failed; likewise.
    std::filesystem::path withheld;
};

/// `NAME.walk.yaml-snapshots/[PROJECT-]FILE` beside the walk file: a reference that runs are compared with.
std::filesystem::path reference_file(const std::filesystem::path& walk_file, const std::string& project,
                                     const std::string& file);

/// The reference of the log, `log.jsonl`.
std::filesystem::path golden_log_file(const std::filesystem::path& walk_file, const std::string& project);

/// Compares a run's log, as engine::JsonLines writes it, with the walk's golden one. Verdicts are ignored:
/// what is expected of a walk doesn't change where it goes. Nothing is written for a walk that `fails` for
/// other reasons: a golden log must have been right once. Files are written atomically, also by several
/// processes at the same time. Throws std::runtime_error when the file can't be read or written.
GoldenCheck check_golden(const std::filesystem::path& walk_file, const std::string& project,
                         std::span<const std::string> lines, UpdateSnapshots mode, bool fails);

}  // namespace campuswalk::tools
