#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::tools::bench {

/// A picture as the bytes of a PNG file.
using PictureEncoder = std::function<std::vector<std::uint8_t>(const scene::Texture&)>;

/// Writes the model as one GLB file, pictures within it as PNG: what other programs are given. Only what the
/// benchmarks make use of: nodes without parents that stand where their meshes are, opaque materials. A model
/// without pictures needs no `encode`. Throws std::runtime_error when the file can't be written.
void write_glb(const scene::Model& model, const std::filesystem::path& file,
               const PictureEncoder& encode = nullptr);

}  // namespace campuswalk::tools::bench
