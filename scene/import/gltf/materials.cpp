#include "scene/import/gltf/materials.h"

#include <algorithm>
#include <cmath>

#include "scene/import/gltf/fault.h"

namespace campuswalk::scene::gltf {
namespace {

constexpr std::size_t kClampToEdge = 33071;

/// A colour component as a finite number in 0..1.
float sanitize(float value) {
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
}

AlphaMode to_alpha_mode(const std::string& name) {
    return name == "MASK" ? AlphaMode::mask : name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

std::optional<Item> extension_of(const Item& item, const char* name) {
    const auto extensions = item.object("extensions");
    return extensions ? extensions->object(name) : std::nullopt;
}

/// The image of a texture. WebP is taken before what stands in for it; for KTX2 and DDS, which aren't read,
/// what stands in is taken, and without any the reader of images says so.
std::optional<std::size_t> image_of(const Item& texture) {
    if (const auto webp = extension_of(texture, "EXT_texture_webp")) {
        if (const auto source = webp->whole("source")) {
            return source;
        }
    }
    if (const auto source = texture.whole("source")) {
        return source;
    }
    for (const char* unread : {"KHR_texture_basisu", "MSFT_texture_dds", "EXT_texture_avif"}) {
        if (const auto extension = extension_of(texture, unread)) {
            return extension->whole("source");
        }
    }
    return std::nullopt;
}

bool repeats(const Document& document, const Item& texture) {
    const auto sampler = texture.whole("sampler");
    if (!sampler) {
        return true;
    }
    const Item item = document.item("samplers", *sampler);
    return item.whole("wrapS") != kClampToEdge && item.whole("wrapT") != kClampToEdge;
}

/// Scaled, then turned anticlockwise as seen on the image (v runs down), then moved.
void read_transform(const Item& transform, TextureLayout& out) {
    const auto offset = transform.numbers("offset", 2).value_or(std::vector<float>{0, 0});
    const auto scale = transform.numbers("scale", 2).value_or(std::vector<float>{1, 1});
    const auto angle = static_cast<float>(transform.number("rotation", 0.0));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    out.linear << c * scale[0], s * scale[1],  //
        -s * scale[0], c * scale[1];
    out.offset = {offset[0], offset[1]};
}

TextureLayout read_layout(const Item& info) {
    TextureLayout layout;
    std::size_t channel = info.whole("texCoord").value_or(0);
    if (const auto transform = extension_of(info, "KHR_texture_transform")) {
        read_transform(*transform, layout);
        channel = transform->whole("texCoord").value_or(channel);
    }
    layout.channel = static_cast<unsigned int>(std::min<std::size_t>(channel, 1000));
    return layout;
}

/// The image that `holder` names under `key`, if any: its first one says how all of a material's lie.
std::optional<Item> read_image(const Document& document, const Item& holder, const char* key,
                               std::optional<TextureIndex> Material::*use, GltfMaterial& out) {
    auto info = holder.object(key);
    if (!info) {
        return std::nullopt;
    }
    const Item texture = document.item("textures", info->needed_whole("index"));
    const auto image = image_of(texture);
    if (!image) {
        return std::nullopt;
    }
    const TextureLayout layout = read_layout(*info);
    if (out.source.images.empty()) {
        out.layout = layout;
        out.source.uv_channel = layout.channel;
    } else if (!(layout == out.layout)) {
        out.left_out.emplace_back(key);
        return std::nullopt;
    }
    const std::string uri = document.item("images", *image).text("uri");
    const bool embedded = uri.empty() || uri.starts_with("data:");
    out.source.images.push_back(
        {use, {embedded ? "*" + std::to_string(*image) : uri, repeats(document, texture)}});
    return info;
}

/// One of the two ways to name colour and image: `holder`'s keys.
void read_color(const Document& document, const Item& holder, const char* factor, const char* texture,
                GltfMaterial& out) {
    if (const auto color = holder.numbers(factor, 4)) {
        out.source.material.base_color = {sanitize((*color)[0]), sanitize((*color)[1]), sanitize((*color)[2]),
                                          sanitize((*color)[3])};
    }
    read_image(document, holder, texture, &Material::base_color_texture, out);
}

/// Where the surface glows, and how brightly: KHR_materials_emissive_strength may take it over 1.
void read_glow(const Document& document, const Item& item, GltfMaterial& out) {
    constexpr double kBrightest = 100.0;  // already white on any image
    double strength = 1.0;
    if (const auto extension = extension_of(item, "KHR_materials_emissive_strength")) {
        strength = extension->number("emissiveStrength", 1.0);
    }
    if (const auto factor = item.numbers("emissiveFactor", 3)) {
        for (std::size_t i = 0; i < 3; ++i) {
            out.source.material.emissive[i] =
                sanitize((*factor)[i]) *
                static_cast<float>(std::isfinite(strength) ? std::clamp(strength, 0.0, kBrightest) : 1.0);
        }
    }
    const bool named = item.has("emissiveTexture");
    if (named && !read_image(document, item, "emissiveTexture", &Material::emissive_texture, out)) {
        out.source.material.emissive = {0, 0, 0};  // it would say where: not all over
    }
}

void read_metal(const Document& document, const Item& pbr, GltfMaterial& out) {
    out.source.material.metallic = sanitize(static_cast<float>(pbr.number("metallicFactor", 1.0)));
    out.source.material.roughness = sanitize(static_cast<float>(pbr.number("roughnessFactor", 1.0)));
    read_image(document, pbr, "metallicRoughnessTexture", &Material::metallic_roughness_texture, out);
}

GltfMaterial read_material(const Document& document, const Item& item) {
    GltfMaterial out;
    Material& material = out.source.material;
    material.name = item.text("name");
    const auto pbr = item.object("pbrMetallicRoughness");
    const auto older = extension_of(item, "KHR_materials_pbrSpecularGlossiness");
    if (older) {
        read_color(document, *older, "diffuseFactor", "diffuseTexture", out);
    } else if (pbr) {
        read_color(document, *pbr, "baseColorFactor", "baseColorTexture", out);
        read_metal(document, *pbr, out);
    }
    if (const auto normal = read_image(document, item, "normalTexture", &Material::normal_texture, out)) {
        const auto scale = static_cast<float>(normal->number("scale", 1.0));
        material.normal_scale = std::isfinite(scale) ? scale : 1.0F;
    }
    read_glow(document, item, out);
    material.alpha_mode = to_alpha_mode(item.text("alphaMode"));
    material.alpha_cutoff = sanitize(static_cast<float>(item.number("alphaCutoff", 0.5)));
    material.double_sided = item.flag("doubleSided");
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
