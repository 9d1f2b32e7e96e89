#include "scene/import/gltf/materials.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::scene::gltf {
namespace {

constexpr std::size_t kClampToEdge = 33071;
constexpr std::size_t kMirroredRepeat = 33648;

AlphaMode to_alpha_mode(const std::string& name) {
    return name == "MASK" ? AlphaMode::mask : name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

std::optional<JsonObject> extension_of(const JsonObject& item, const char* name) {
    const auto extensions = item.object("extensions");
    return extensions ? extensions->object(name) : std::nullopt;
}

/// The image of a texture. WebP is preferred to its fallback. For unsupported formats (KTX2, DDS, AVIF) the
/// fallback is used; without one, decoding reports the format.
std::optional<std::size_t> image_of(const JsonObject& texture) {
    if (const auto webp = extension_of(texture, "EXT_texture_webp")) {
        if (const auto source = webp->uint("source")) {
            return source;
        }
    }
    if (const auto source = texture.uint("source")) {
        return source;
    }
    for (const char* unsupported : {"KHR_texture_basisu", "MSFT_texture_dds", "EXT_texture_avif"}) {
        if (const auto extension = extension_of(texture, unsupported)) {
            return extension->uint("source");
        }
    }
    return std::nullopt;
}

Wrap wrap_of(const JsonObject& sampler, const char* axis) {
    const auto mode = sampler.uint(axis);
    return mode == kClampToEdge ? Wrap::clamp : mode == kMirroredRepeat ? Wrap::mirror : Wrap::repeat;
}

TextureWrap wrap_of(const Document& document, const JsonObject& texture) {
    const auto sampler = texture.uint("sampler");
    if (!sampler) {
        return {};
    }
    const JsonObject item = document.item("samplers", *sampler);
    return {wrap_of(item, "wrapS"), wrap_of(item, "wrapT")};
}

/// Scale, then rotation (counter-clockwise on the image, since v points down), then offset.
void read_transform(const JsonObject& transform, TextureLayout& out) {
    const auto offset = transform.floats("offset", 2).value_or(std::vector<float>{0, 0});
    const auto scale = transform.floats("scale", 2).value_or(std::vector<float>{1, 1});
    const auto angle = static_cast<float>(transform.number("rotation", 0.0));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    out.linear << c * scale[0], s * scale[1],  //
        -s * scale[0], c * scale[1];
    out.offset = {offset[0], offset[1]};
}

TextureLayout read_layout(const JsonObject& info) {
    TextureLayout layout;
    std::size_t channel = info.uint("texCoord").value_or(0);
    if (const auto transform = extension_of(info, "KHR_texture_transform")) {
        read_transform(*transform, layout);
        channel = transform->uint("texCoord").value_or(channel);
    }
    layout.channel = static_cast<unsigned int>(std::min<std::size_t>(channel, 1000));
    return layout;
}

/// Adds the image that `holder` has under `key`. The layout of a material's first image applies to all;
/// images with another layout are ignored. Returns the texture info of an added image.
std::optional<JsonObject> read_image(const Document& document, const JsonObject& holder, const char* key,
                                     std::optional<TextureIndex> Material::*use, GltfMaterial& out) {
    auto info = holder.object(key);
    if (!info) {
        return std::nullopt;
    }
    const JsonObject texture = document.item("textures", info->required_uint("index"));
    const auto image = image_of(texture);
    if (!image) {
        return std::nullopt;
    }
    const TextureLayout layout = read_layout(*info);
    if (out.source.images.empty()) {
        out.layout = layout;
        out.source.uv_channel = layout.channel;
    } else if (!(layout == out.layout)) {
        out.ignored_images.emplace_back(key);
        return std::nullopt;
    }
    const std::string uri = document.item("images", *image).string("uri");
    const bool embedded = uri.empty() || uri.starts_with("data:");
    out.source.images.push_back(
        {use, {embedded ? "*" + std::to_string(*image) : uri, wrap_of(document, texture)}});
    return info;
}

/// Base colour and its image from `holder`'s keys.
void read_color(const Document& document, const JsonObject& holder, const char* factor, const char* texture,
                GltfMaterial& out) {
    if (const auto color = holder.floats(factor, 4)) {
        out.source.material.base_color = {unit_factor((*color)[0]), unit_factor((*color)[1]),
                                          unit_factor((*color)[2]), unit_factor((*color)[3])};
    }
    read_image(document, holder, texture, &Material::base_color_texture, out);
}

/// KHR_materials_emissive_strength may exceed 1.
void read_emission(const Document& document, const JsonObject& item, GltfMaterial& out) {
    constexpr double kMaxStrength = 100.0;  // white in any image
    double strength = 1.0;
    if (const auto extension = extension_of(item, "KHR_materials_emissive_strength")) {
        strength = extension->number("emissiveStrength", 1.0);
    }
    if (const auto factor = item.floats("emissiveFactor", 3)) {
        for (std::size_t i = 0; i < 3; ++i) {
            out.source.material.emissive[i] =
                unit_factor((*factor)[i]) *
                static_cast<float>(std::isfinite(strength) ? std::clamp(strength, 0.0, kMaxStrength) : 1.0);
        }
    }
    const bool textured = item.has("emissiveTexture");
    if (textured && !read_image(document, item, "emissiveTexture", &Material::emissive_texture, out)) {
        out.source.material.emissive = {0, 0, 0};  // the texture says where it glows; without it, nowhere
    }
}

void read_metallic_roughness(const Document& document, const JsonObject& pbr, GltfMaterial& out) {
    out.source.material.metallic = unit_factor(static_cast<float>(pbr.number("metallicFactor", 1.0)));
    out.source.material.roughness = unit_factor(static_cast<float>(pbr.number("roughnessFactor", 1.0)));
    read_image(document, pbr, "metallicRoughnessTexture", &Material::metallic_roughness_texture, out);
}

GltfMaterial read_material(const Document& document, const JsonObject& item) {
    GltfMaterial out;
    Material& material = out.source.material;
    material.name = item.string("name");
    const auto pbr = item.object("pbrMetallicRoughness");
    const auto specular_glossiness = extension_of(item, "KHR_materials_pbrSpecularGlossiness");
    if (specular_glossiness) {
        read_color(document, *specular_glossiness, "diffuseFactor", "diffuseTexture", out);
    } else if (pbr) {
        read_color(document, *pbr, "baseColorFactor", "baseColorTexture", out);
        read_metallic_roughness(document, *pbr, out);
    }
    if (const auto normal = read_image(document, item, "normalTexture", &Material::normal_texture, out)) {
        const auto scale = static_cast<float>(normal->number("scale", 1.0));
        material.normal_scale = std::isfinite(scale) ? scale : 1.0F;
    }
    read_emission(document, item, out);
    material.alpha_mode = to_alpha_mode(item.string("alphaMode"));
    material.alpha_cutoff = unit_factor(static_cast<float>(item.number("alphaCutoff", 0.5)));
    material.double_sided = item.boolean("doubleSided");
    material.unlit = extension_of(item, "KHR_materials_unlit").has_value();
    return out;
}

}  // namespace

std::vector<GltfMaterial> read_materials(const Document& document) {
    std::vector<GltfMaterial> materials;
    const std::size_t count = document.size("materials");
    materials.reserve(count + 1);
    for (std::size_t i = 0; i < count; ++i) {
        materials.push_back(read_material(document, document.item("materials", i)));
    }
    materials.emplace_back();
    return materials;
}

}  // namespace campuswalk::scene::gltf
