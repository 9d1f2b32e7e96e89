#pragma once

#include <filesystem>

#include "scene/model.h"

namespace campuswalk::tools::bench {

/// Writes the model as one GLB file, pictures within it as PNG: what other programs are given to draw. Only
/// what drawn_campus() makes use of: nodes without parents that stand where their meshes are, opaque
/// materials. Throws std::runtime_error when the file can't be written.
void write_glb(const scene::Model& model, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench
