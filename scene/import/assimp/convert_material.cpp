#include "scene/import/assimp/convert_material.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <assimp/material.h>

namespace campuswalk::scene {
namespace {

// Below this, an exporter confused opacity with transparency: nobody models invisible surfaces.
constexpr float kMinOpacity = 0.02F;
constexpr float kBlack = 0.01F;

float linear_from_srgb(float value) {
    const float v = unit_factor(value);
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

Wrap wrap_of(aiTextureMapMode mode) {
    return mode == aiTextureMapMode_Mirror                                    ? Wrap::mirror
           : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? Wrap::clamp
                                                                              : Wrap::repeat;
}

/// Adds the image of the first of `types` that the material has. The texture coordinates of a material's
/// first image apply to all: in practice these formats have one set.
void add_image(const aiMaterial& source, std::initializer_list<aiTextureType> types,
               std::optional<TextureIndex> Material::*use, SourceMaterial& out) {
    for (const aiTextureType type : types) {
        aiString path;
        unsigned int channel = 0;
        aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
        if (source.GetTexture(type, 0, &path, nullptr, &channel, nullptr, nullptr, modes) ==
                aiReturn_SUCCESS &&
            path.length > 0) {
            if (out.images.empty()) {
                out.uv_channel = channel;
            }
            out.images.push_back({use, {path.C_Str(), {wrap_of(modes[0]), wrap_of(modes[1])}}});
            return;
        }
    }
}

/// Diffuse colours of older formats are sRGB, and often black if there is a texture.
void convert_color(const aiMaterial& source, const aiColor4D& diffuse, SourceMaterial& out) {
    const bool textured = !out.images.empty();
    const bool black = std::max({diffuse.r, diffuse.g, diffuse.b}) < kBlack;
    auto& color = out.material.base_color;
    if (!(textured && black)) {
        color = {linear_from_srgb(diffuse.r), linear_from_srgb(diffuse.g), linear_from_srgb(diffuse.b), 1.0F};
    }
    float opacity = 1.0F;
    source.Get(AI_MATKEY_OPACITY, opacity);
    if (std::isfinite(opacity) && opacity >= kMinOpacity && opacity < 1.0F) {
        color[3] = opacity;
        out.material.alpha_mode = AlphaMode::blend;
    }
}

}  // namespace

SourceMaterial convert_material(const aiMaterial& source) {
    SourceMaterial out;
    Material& material = out.material;
    aiString name;
    if (source.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) {
        material.name = name.C_Str();
    }
    add_image(source, {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}, &Material::base_color_texture, out);

    aiColor4D diffuse(1, 1, 1, 1);
    source.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse);
    aiColor3D emissive(0, 0, 0);
    source.Get(AI_MATKEY_COLOR_EMISSIVE, emissive);
    convert_color(source, diffuse, out);
    material.emissive = {linear_from_srgb(emissive.r), linear_from_srgb(emissive.g),
                         linear_from_srgb(emissive.b)};
    material.double_sided = true;
    out.cut_out_by_texture = material.alpha_mode == AlphaMode::opaque;
    const std::size_t images = out.images.size();
    add_image(source, {aiTextureType_EMISSIVE}, &Material::emissive_texture, out);
    if (out.images.size() > images && std::ranges::max(material.emissive) < kBlack) {
        material.emissive = {1, 1, 1};  // black beside a texture means no factor
    }
    add_image(source, {aiTextureType_NORMALS}, &Material::normal_texture, out);
    return out;
}

}  // namespace campuswalk::scene
