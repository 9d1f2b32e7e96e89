#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::tools::bench {

/// Encodes an image as the bytes of a PNG file.
using ImageEncoder = std::function<std::vector<std::uint8_t>(const scene::Texture&)>;

/// Writes the model for other programs as one GLB file with embedded PNG images. Supports only what the
/// benchmarks use: nodes without parents or transforms, and opaque materials. A model without images needs no
/// `encode`. Throws std::runtime_error when the file can't be written.
void write_glb(const scene::Model& model, const std::filesystem::path& file,
               const ImageEncoder& encode = nullptr);

}  // namespace campuswalk::tools::bench
