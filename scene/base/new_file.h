#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace campuswalk::scene {

struct CloseStream {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
};
using FileStream = std::unique_ptr<std::FILE, CloseStream>;

/// Opens a new, empty file for writing, and makes its folder. A file or a link of this name is replaced,
/// never written into or followed: it may be known by another name elsewhere. Only a file in a folder that
/// can't be changed is emptied and written into, if it has no other name. Throws std::runtime_error with the
/// file's name and the system's reason, also if a folder, a pipe or a device has this name.
FileStream open_new_file(const std::filesystem::path& file);

/// Whether there is something at the end of the path's links that is no file of its own: a pipe, a socket, a
/// device, or an open file, such as /dev/stdout.
bool is_stream(const std::filesystem::path& path);

/// Opens a stream that the user named. Throws std::runtime_error as above.
FileStream open_stream(const std::filesystem::path& path);

/// Writes a file that nobody knows of yet, such as one that a result will name once it is whole: half the
/// cost of write_file_atomically, but a process that is killed may leave a part of it. Replaces and throws
/// like open_new_file, and leaves no file then.
void write_new_file(const std::filesystem::path& file, std::string_view text);

}  // namespace campuswalk::scene
