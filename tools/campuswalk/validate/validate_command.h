#pragma once

#include <filesystem>
#include <vector>

namespace campuswalk::tools {

enum class ValidateFormat { text, json, sarif, github };

struct ValidateOptions {
    std::vector<std::filesystem::path> paths;  ///< files, or folders to look for such files in
    ValidateFormat format = ValidateFormat::text;
};

/// Reads and checks YAML files as `run` would, and runs nothing. Returns the exit code.
int validate_files(const ValidateOptions& options);

}  // namespace campuswalk::tools
