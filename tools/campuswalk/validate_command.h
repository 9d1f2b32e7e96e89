#pragma once

#include <filesystem>
#include <vector>

namespace campuswalk::tools {

/// Reads and checks walks, campuses and avatars as `run` would, and runs nothing. Returns the exit code.
int validate_files(const std::vector<std::filesystem::path>& files);

}  // namespace campuswalk::tools
