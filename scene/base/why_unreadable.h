#pragma once

#include <filesystem>
#include <string>

namespace campuswalk::scene {

/// Why a file that was named can't be read, and what to do: it isn't there, is a folder, a pipe, a socket or
/// a device, which may wait or never end, or this process may not read it. Empty if it can be read.
std::string why_unreadable(const std::filesystem::path& file);

}  // namespace campuswalk::scene
