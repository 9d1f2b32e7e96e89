#pragma once

#include <filesystem>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Reads a PNG file of any kind: 16 bits are rounded to 8, palettes and greyscale become RGB, and
/// transparency is blended over white. Throws scene::InputError (missing-file, unreadable-file, bad-image)
/// that names the file.
Image read_png(const std::filesystem::path& file);

}  // namespace campuswalk::engine::render
