#pragma once

#include <filesystem>
#include <string_view>

namespace campuswalk::scene {

/// Writes a file that nobody knows of yet, such as one that a result will name once it is whole: half the
/// cost of write_file_atomically, but a process that is killed may leave a part of it. A file or a link of
/// this name is replaced, never followed; the folder is made. Throws std::runtime_error with the file's name
/// and the system's reason, and leaves no file then.
void write_new_file(const std::filesystem::path& file, std::string_view text);

}  // namespace campuswalk::scene
