#pragma once

#include <optional>
#include <string>

#include "scene/model.h"

struct aiMaterial;

namespace campuswalk::scene {

/// A picture as a material names it: a path, or `*N` for the N-th that is embedded in the file.
struct TextureReference {
    std::string uri;
    unsigned int uv_channel = 0;
    bool repeat = true;
};

struct ConvertedMaterial {
    Material material;  ///< without its texture, which is loaded apart
    std::optional<TextureReference> texture;
    bool cut_out_by_texture = false;  ///< no alpha mode in the file: a texture with holes makes it `mask`
};

/// glTF's base colour and the diffuse colour of older formats alike. Those older formats know neither culling
/// nor alpha modes: their materials are drawn from both sides, and as blended when their opacity is below 1.
ConvertedMaterial convert_material(const aiMaterial& source);

}  // namespace campuswalk::scene
