#include "scene/import/texture_loader.h"

#include <span>

#include <assimp/scene.h>

#include "scene/import/decode_image.h"
#include "scene/import/locked_files.h"

namespace campuswalk::scene {
namespace {

std::optional<Texture> to_texture(std::span<const std::uint8_t> bytes, std::string& reason) {
    auto image = decode_image(bytes, reason);
    if (!image) {
        reason = "cannot be decoded (" + reason + "); use PNG or JPEG";
        return std::nullopt;
    }
    Texture texture;
    texture.width = image->width;
    texture.height = image->height;
    texture.rgba = std::move(image->rgba);
    return texture;
}

/// Uncompressed pixels that an importer unpacked already.
Texture from_texels(const aiTexture& source) {
    Texture texture;
    texture.width = static_cast<int>(source.mWidth);
    texture.height = static_cast<int>(source.mHeight);
    const std::size_t count = static_cast<std::size_t>(source.mWidth) * source.mHeight;
    texture.rgba.reserve(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const aiTexel& texel = source.pcData[i];
        texture.rgba.insert(texture.rgba.end(), {texel.r, texel.g, texel.b, texel.a});
    }
    return texture;
}

}  // namespace

std::optional<Texture> TextureLoader::decode(const TextureReference& reference, std::string& reason) const {
    if (const aiTexture* embedded = scene_.GetEmbeddedTexture(reference.uri.c_str())) {
        if (embedded->mHeight > 0) {
            return from_texels(*embedded);
        }
        return to_texture({reinterpret_cast<const std::uint8_t*>(embedded->pcData), embedded->mWidth},
                          reason);
    }
    const auto path = folder_.find_picture(reference.uri);
    if (!path) {
        reason =
            "is missing, or lies outside the folders a scene may read (its own and below, or textures/, "
            "materials/, images/, maps/ beside it)";
        return std::nullopt;
    }
    const auto bytes = read_bytes(*path);
    if (!bytes) {
        reason = "cannot be read";
        return std::nullopt;
    }
    return to_texture(*bytes, reason);
}

std::optional<TextureIndex> TextureLoader::load(const TextureReference& reference, std::string& reason) {
    const std::pair key(reference.uri, reference.repeat);
    if (const auto found = loaded_.find(key); found != loaded_.end()) {
        return found->second;
    }
    auto texture = decode(reference, reason);
    if (!texture) {
        return std::nullopt;
    }
    texture->name = reference.uri;
    texture->repeat = reference.repeat;
    const auto index = static_cast<TextureIndex>(textures_.size());
    textures_.push_back(std::move(*texture));
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
