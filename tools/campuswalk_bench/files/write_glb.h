#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::tools::bench {

/// An image as the bytes of a PNG file.
using ImageEncoder = std::function<std::vector<std::uint8_t>(const scene::Texture&)>;

/// Writes the model as one GLB file, images within it as PNG: what other programs are given. Only what the
/// benchmarks make use of: nodes without parents that stand where their meshes are, opaque materials. A model
/// without images needs no `encode`. Throws std::runtime_error when the file can't be written.
void write_glb(const scene::Model& model, const std::filesystem::path& file,
               const ImageEncoder& encode = nullptr);

}  // namespace campuswalk::tools::bench
