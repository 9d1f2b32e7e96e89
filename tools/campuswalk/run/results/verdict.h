#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"

namespace campuswalk::tools {

/// Whether the case passed or was skipped.
bool is_good(const engine::WalkResult& result);

/// The lines for standard error: failures with their places and their images, which are below `output`, then
/// how the case ended.
std::vector<std::string> verdict_lines(const engine::WalkResult& result, const std::filesystem::path& output);

/// Of a run with these outcomes. Errors while running take precedence over bad input, and that over failures.
int exit_code_of(const std::set<engine::Outcome>& outcomes);
int exit_code_for(const std::vector<engine::WalkResult>& results);

/// Makes the later repetition fail if its ticks or its hash differ from those of the first.
void compare_repetitions(const engine::WalkResult& first, engine::WalkResult& later);

}  // namespace campuswalk::tools
