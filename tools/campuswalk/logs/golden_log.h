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

/// A golden file that is to be written once the whole walk has been evaluated: it must have been right once.
struct GoldenUpdate {
    std::filesystem::path file;  ///< relative like the walk file
    std::string bytes;
};

/// The result of comparing a run with a golden log.
struct GoldenCheck {
    /// The log differs (code "log"), or the golden one is missing (kGoldenMissing). Its scene has what the
    /// log tells: the tick of the divergence or the last one, and the events before it. The caller sets the
    /// mark and the rest.
    std::optional<engine::Failure> failure;
    std::optional<GoldenUpdate> update;  ///< instead of a failure, if the mode allows it
};

/// `NAME.walk.yaml-snapshots/[PROJECT-]FILE` beside the walk file: a reference that runs are compared with.
std::filesystem::path reference_file(const std::filesystem::path& walk_file, const std::string& project,
                                     const std::string& file);

/// The reference of the log, `log.jsonl`.
std::filesystem::path golden_log_file(const std::filesystem::path& walk_file, const std::string& project);

/// Compares a run's log, as engine::JsonLines writes it, with the walk's golden one. Verdicts are ignored:
/// what is expected of a walk doesn't change where it goes. Throws scene::InputError (unreadable) when the
/// file can't be read or isn't a log.
GoldenCheck check_golden(const std::filesystem::path& walk_file, const std::string& project,
                         std::span<const std::string> lines, UpdateSnapshots mode);

}  // namespace campuswalk::tools
