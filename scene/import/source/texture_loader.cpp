#include "scene/import/source/texture_loader.h"

namespace campuswalk::scene {

std::optional<TextureIndex> TextureLoader::load(const TextureReference& reference, std::string& reason) {
    const std::pair key(reference.uri, reference.repeat);
    if (const auto found = loaded_.find(key); found != loaded_.end()) {
        return found->second;
    }
    auto image = source_.load_image(reference, reason);
    if (!image) {
        return std::nullopt;
    }
    Texture texture;
    texture.name = reference.uri;
    texture.width = image->width;
    texture.height = image->height;
    texture.rgba = std::move(image->rgba);
    texture.repeat = reference.repeat;
    const auto index = static_cast<TextureIndex>(textures_.size());
    textures_.push_back(std::move(texture));
    loaded_.emplace(key, index);
    return index;
}

bool has_cut_outs(const Texture& texture) {
    constexpr std::uint8_t kClear = 64;
    bool clear = false;
    bool solid = false;
    for (std::size_t i = 3; i < texture.rgba.size(); i += 4) {
        clear = clear || texture.rgba[i] < kClear;
        solid = solid || texture.rgba[i] == 255;
    }
    return clear && solid;
}

}  // namespace campuswalk::scene
