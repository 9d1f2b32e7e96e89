#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// A text file's lines without their ends. Throws scene::InputError when there is no such file or it can't be
/// read.
std::vector<std::string> read_lines(const std::filesystem::path& file);

}  // namespace campuswalk::tools
