#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace campuswalk::tools {

/// What a file is by its name.
enum class FileKind { walk, campus, avatar, light, steps, config };

std::optional<FileKind> kind_of(const std::filesystem::path& file);

/// The path itself, or instead of a folder the files of a known kind in it and below, sorted. Folders whose
/// name starts with a dot are left out. Throws scene::InputError for a folder without any.
std::vector<std::filesystem::path> found_files(const std::filesystem::path& path);

}  // namespace campuswalk::tools
