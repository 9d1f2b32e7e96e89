#pragma once

#include <cstdint>
#include <vector>

namespace campuswalk::engine::render {

/// A PNG file's bytes: 16-bit grey, rows from top to bottom, the same bytes for the same values.
std::vector<std::uint8_t> encode_depth_png(int width, int height, const std::vector<std::uint16_t>& values);

}  // namespace campuswalk::engine::render
