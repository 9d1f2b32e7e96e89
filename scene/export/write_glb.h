#pragma once

#include <functional>
#include <span>
#include <string>

#include "scene/export/mesh_groups.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

struct GlbSettings {
    /// Metres that the surface may move; 0: no triangle is left out, and positions keep their 32-bit floats.
    double error = 0.05;
    int texture_size = 512;  ///< pixels a side; larger textures are shrunk
};

struct GlbFile {
    std::string bytes;
    std::size_t triangles = 0;
    std::size_t source_triangles = 0;  ///< of the models, as placed
};

/// Several models in one binary glTF 2.0, for looking at: its nodes are not the models', but groups of
/// triangles that share material, tags and square of the ground. Each has `extras: {objects: [tags], node:
/// "…"}`, the node that all of it comes from, if that is one. Compressed by EXT_meshopt_compression, textures
/// as WebP; with an error positions are multiples of two millimetres (KHR_mesh_quantization). The same models
/// give the same bytes.
GlbFile write_glb(std::span<const Model> models, const GlbSettings& settings,
                  const std::function<Tags(std::size_t model, std::size_t node)>& tags_of);

}  // namespace campuswalk::scene
