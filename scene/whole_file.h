#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace campuswalk::scene {

/// Writes a file whole or not at all, with the folders it needs: a neighbour of a name of its own is renamed
/// over it, so that several processes may write the same file at a time, and who reads it meanwhile reads the
/// old one or the new. Throws std::runtime_error with the file and the system's reason; what is there but is
/// no regular file, such as a device, is left alone.
void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_whole_file(const std::filesystem::path& file, std::string_view text);
/// Of bytes that lie in several places.
void write_whole_file(const std::filesystem::path& file, std::span<const std::span<const std::byte>> parts);

/// How the neighbours' names end, should a process be killed and leave one behind.
inline constexpr std::string_view kPartSuffix = ".part";

}  // namespace campuswalk::scene
