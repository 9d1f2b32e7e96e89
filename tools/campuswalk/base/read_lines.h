#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// The lines of a text file without their line ends. Throws scene::InputError when the file is missing,
/// isn't a regular one or can't be read.
std::vector<std::string> read_lines(const std::filesystem::path& file);

/// The bytes of a file; throws likewise.
std::string read_bytes(const std::filesystem::path& file);

}  // namespace campuswalk::tools
