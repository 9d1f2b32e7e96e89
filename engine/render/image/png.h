#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Encodes as 8-bit RGB; the same image gives the same bytes. `software`, if any, is named in the file.
std::vector<std::uint8_t> encode_png(const Image& image, std::string_view software = {});

/// Encodes as 16-bit greyscale, rows from top to bottom.
std::vector<std::uint8_t> encode_depth_png(int width, int height, const std::vector<std::uint16_t>& values);

/// Writes `file` atomically (through a temporary file); creates its folder if missing. Throws
/// std::runtime_error that names the file and the system's reason.
void write_png(const Image& image, const std::filesystem::path& file, std::string_view software = {});

}  // namespace campuswalk::engine::render
