#pragma once

#include <filesystem>
#include <string_view>

namespace campuswalk::tools {

/// Writes a file whole or not at all, with the folders it needs: a neighbour of this process' own is renamed
/// over it, so that several may write the same file at a time. Throws std::runtime_error with the file and
/// the system's reason.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace campuswalk::tools
