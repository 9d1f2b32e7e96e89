#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace campuswalk::tools {

/// The bytes of a file below `folder`. None if there is no such regular file, or if `path`, which results
/// from elsewhere name, leads out of the folder or through a symbolic link.
std::optional<std::string> read_below(const std::filesystem::path& folder, const std::string& path);

}  // namespace campuswalk::tools
