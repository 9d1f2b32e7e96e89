#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// Looks at a line, by its number from 1, before the next one is read. May throw.
using LineCheck = std::function<void(int number, const std::string& line)>;

/// The lines of a text file without their line ends. Throws scene::InputError when the file is missing,
/// isn't a regular one or can't be read (unreadable), for a line that is too long (long-line), and
/// what the check throws.
std::vector<std::string> read_lines(const std::filesystem::path& file, const LineCheck& check = {});

/// The bytes of a file; throws likewise.
std::string read_bytes(const std::filesystem::path& file);

}  // namespace campuswalk::tools
