#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"

namespace campuswalk::tools {

/// Whether the case is as it should be: passed or skipped.
bool is_good(const engine::WalkResult& result);

/// What a person is told on standard error, a line each: failures with their places and, below `output`,
/// their images, then how it ended.
std::vector<std::string> verdict_lines(const engine::WalkResult& result, const std::filesystem::path& output);

/// Of a run with these results: what went wrong while running goes before bad input, that before failures.
int exit_code_for(const std::vector<engine::WalkResult>& results);

/// A failure when the repetition's ticks or events aren't those of the first.
void compare_repetitions(const engine::WalkResult& first, engine::WalkResult& later);

}  // namespace campuswalk::tools
