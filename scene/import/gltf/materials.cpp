#include "scene/import/gltf/materials.h"

#include <algorithm>
#include <cmath>

#include "scene/import/gltf/fault.h"

namespace campuswalk::scene::gltf {
namespace {

constexpr std::size_t kClampToEdge = 33071;

/// A colour component as a finite number in 0..1.
float tidy(float value) {
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
/// what stands in is taken, and without any the reader of pictures says so.
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

/// Scaled, then turned anticlockwise as seen on the picture (v runs down), then moved.
void read_transform(const Item& transform, GltfMaterial& out) {
    const auto offset = transform.numbers("offset", 2).value_or(std::vector<float>{0, 0});
    const auto scale = transform.numbers("scale", 2).value_or(std::vector<float>{1, 1});
    const auto angle = static_cast<float>(transform.number("rotation", 0.0));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    out.uv_linear << c * scale[0], s * scale[1],  //
        -s * scale[0], c * scale[1];
    out.uv_offset = {offset[0], offset[1]};
}

void read_texture(const Document& document, const Item& info, GltfMaterial& out) {
    const Item texture = document.item("textures", info.needed_whole("index"));
    const auto image = image_of(texture);
    if (!image) {
        return;
    }
    TextureReference reference;
    const std::string uri = document.item("images", *image).text("uri");
    reference.uri = uri.empty() || uri.starts_with("data:") ? "*" + std::to_string(*image) : uri;
    reference.repeat = repeats(document, texture);
    std::size_t channel = info.whole("texCoord").value_or(0);
    if (const auto transform = extension_of(info, "KHR_texture_transform")) {
        read_transform(*transform, out);
        channel = transform->whole("texCoord").value_or(channel);
    }
    reference.uv_channel = static_cast<unsigned int>(std::min<std::size_t>(channel, 1000));
    out.source.texture = reference;
}

/// One of the two ways to name colour and picture: `holder`'s keys.
void read_color(const Document& document, const Item& holder, const char* factor, const char* texture,
                GltfMaterial& out) {
    if (const auto color = holder.numbers(factor, 4)) {
        out.source.material.base_color = {tidy((*color)[0]), tidy((*color)[1]), tidy((*color)[2]),
                                          tidy((*color)[3])};
    }
    if (const auto info = holder.object(texture)) {
        read_texture(document, *info, out);
    }
}

GltfMaterial read_material(const Document& document, const Item& item) {
    GltfMaterial out;
    Material& material = out.source.material;
    material.name = item.text("name");
    if (const auto pbr = item.object("pbrMetallicRoughness")) {
        read_color(document, *pbr, "baseColorFactor", "baseColorTexture", out);
    }
    if (const auto older = extension_of(item, "KHR_materials_pbrSpecularGlossiness")) {
        read_color(document, *older, "diffuseFactor", "diffuseTexture", out);
    }
    material.alpha_mode = to_alpha_mode(item.text("alphaMode"));
    material.alpha_cutoff = tidy(static_cast<float>(item.number("alphaCutoff", 0.5)));
    material.double_sided = item.flag("doubleSided");
    // An emissive texture says where it glows; without it the whole surface would.
    const auto emissive = item.numbers("emissiveFactor", 3);
    if (emissive && !item.has("emissiveTexture")) {
        material.emissive = {tidy((*emissive)[0]), tidy((*emissive)[1]), tidy((*emissive)[2])};
    }
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
