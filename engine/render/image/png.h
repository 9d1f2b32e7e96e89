#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// A PNG file's bytes: 8-bit RGB, the same bytes for the same image.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Writes `file` whole or not at all (a temporary neighbour is renamed over it); its folder is made when
/// missing. Throws std::runtime_error that names the file and the system's reason.
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace campuswalk::engine::render
