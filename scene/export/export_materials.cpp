#include "scene/export/export_materials.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "scene/export/webp_image.h"

namespace campuswalk::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<int, 3> kWrapModes = {10497, 33071, 33648};  // of glTF, in the order of Wrap
constexpr float kTextureQuality = 80.0F;                          // of 100

Json list_of(std::span<const float> values) {
    Json list = Json::array();
    for (const float value : values) {
        list.push_back(value);
    }
    return list;
}

void add_alpha(const Material& material, Json& json) {
    if (material.alpha_mode == AlphaMode::mask) {
        json["alphaMode"] = "MASK";
        json["alphaCutoff"] = material.alpha_cutoff;
    } else if (material.alpha_mode == AlphaMode::blend) {
        json["alphaMode"] = "BLEND";
    }
    if (material.double_sided) {
        json["doubleSided"] = true;
    }
}

/// Factors above 1 need an extension.
void add_emission(const Material& material, Json& json) {
    const float most = std::ranges::max(material.emissive);
    if (most <= 0.0F) {
        return;
    }
    std::array<float, 3> factor = material.emissive;
    if (most > 1.0F) {
        for (float& value : factor) {
            value /= most;
        }
        json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", most}};
    }
    json["emissiveFactor"] = list_of(factor);
}

}  // namespace

ExportMaterials::ExportMaterials(std::span<const Model> models, int texture_size, GlbBuffers& buffers)
    : models_(models), texture_size_(texture_size), buffers_(buffers) {}

std::size_t ExportMaterials::number_of(std::size_t model, MaterialIndex material) {
    const std::vector<Material>& all = models_[model].materials;
    const std::size_t index = std::min(index_of(material), all.size());  // beyond: none
    const auto known = known_.find({model, index});
    if (known != known_.end()) {
        return known->second;
    }
    const std::string json = json_of(model, index < all.size() ? all[index] : Material());
    const auto [there, is_new] = numbers_.try_emplace(json, materials_.size());
    if (is_new) {
        materials_.push_back(json);
    }
    return known_[{model, index}] = there->second;
}

std::string ExportMaterials::json_of(std::size_t model, const Material& material) {
    const auto textured = [&](const std::optional<TextureIndex>& texture) -> std::optional<Json> {
        if (!texture || index_of(*texture) >= models_[model].textures.size()) {
            return std::nullopt;
        }
        return Json{{"index", texture_of(model, *texture)}};
    };
    Json pbr = {{"baseColorFactor", list_of(material.base_color)},
                {"metallicFactor", material.metallic},
                {"roughnessFactor", material.roughness}};
    if (auto texture = textured(material.base_color_texture)) {
        pbr["baseColorTexture"] = std::move(*texture);
    }
    if (auto texture = textured(material.metallic_roughness_texture)) {
        pbr["metallicRoughnessTexture"] = std::move(*texture);
    }
    Json json = {{"pbrMetallicRoughness", std::move(pbr)}};
    if (auto texture = textured(material.normal_texture)) {
        (*texture)["scale"] = material.normal_scale;
        json["normalTexture"] = std::move(*texture);
    }
    if (auto texture = textured(material.emissive_texture)) {
        json["emissiveTexture"] = std::move(*texture);
    }
    add_emission(material, json);
    add_alpha(material, json);
    if (material.unlit) {
        json["extensions"]["KHR_materials_unlit"] = Json::object();
    }
    return json.dump();
}

std::size_t ExportMaterials::texture_of(std::size_t model, TextureIndex index) {
    const Texture& texture = models_[model].textures[index_of(index)];
    const auto known = known_images_.find({model, index_of(index)});
    const std::size_t image = known != known_images_.end() ? known->second : image_of(texture);
    known_images_[{model, index_of(index)}] = image;
    const std::pair key(image, texture.wrap);
    const auto [there, is_new] = textures_.try_emplace(key, texture_list_.size());
    if (is_new) {
        texture_list_.push_back(key);
        if (std::ranges::find(samplers_, texture.wrap) == samplers_.end()) {
            samplers_.push_back(texture.wrap);
        }
    }
    return there->second;
}

/// Models that share a file have its pixels each, but the bytes are the same.
std::size_t ExportMaterials::image_of(const Texture& texture) {
    const PixelView pixels{texture.width, texture.height, {texture.rgba.data(), texture.rgba.size()}};
    std::string bytes =
        encode_webp(shrunk_to_fit(pixels, texture_size_, texture_size_).view(), kTextureQuality);
    const auto known = images_.find(bytes);
    if (known != images_.end()) {
        return known->second;
    }
    const std::size_t number = buffers_.append_image(bytes);
    images_.emplace(std::move(bytes), number);
    return number;
}

std::string ExportMaterials::json(std::size_t first_image) const {
    std::string text = "\"materials\":[";
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        text += (i == 0 ? "" : ",") + materials_[i];
    }
    text += "]";
    if (texture_list_.empty()) {
        return text;
    }
    Json images = Json::array();
    for (std::size_t i = 0; i < images_.size(); ++i) {
        images.push_back({{"bufferView", first_image + i}, {"mimeType", "image/webp"}});
    }
    Json samplers = Json::array();
    for (const TextureWrap& wrap : samplers_) {
        samplers.push_back({{"magFilter", 9729},
                            {"minFilter", 9987},
                            {"wrapS", kWrapModes.at(static_cast<std::size_t>(wrap.u))},
                            {"wrapT", kWrapModes.at(static_cast<std::size_t>(wrap.v))}});
    }
    Json textures = Json::array();
    for (const auto& [image, wrap] : texture_list_) {
        const auto sampler = std::ranges::find(samplers_, wrap) - samplers_.begin();
        textures.push_back(
            {{"sampler", sampler}, {"extensions", {{"EXT_texture_webp", {{"source", image}}}}}});
    }
    return text + ",\"images\":" + images.dump() + ",\"samplers\":" + samplers.dump() +
           ",\"textures\":" + textures.dump();
}

}  // namespace campuswalk::scene
