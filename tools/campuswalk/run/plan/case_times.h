#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace campuswalk::tools {

/// Microseconds of wall clock that cases took, by their ids. Whole numbers, so that every machine adds them
/// up to the same sums.
using CaseTimes = std::map<std::string, std::uint64_t>;

/// What a saved result has before its own fields. See last_run.h.
inline constexpr const char* kMicroseconds = "microseconds";

/// Adds the times of a file of JSON lines with `id` and `microseconds`, such as a run's last-run.jsonl;
/// others are passed over, and a later line counts. Throws scene::InputError: missing-file; bad-times for a
/// line that isn't JSON.
void add_case_times(const std::filesystem::path& file, CaseTimes& times);

/// As lines of such a file.
std::string to_json_lines(const CaseTimes& times);

}  // namespace campuswalk::tools
