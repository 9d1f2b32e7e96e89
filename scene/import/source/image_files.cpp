#include "scene/import/source/image_files.h"

#include "scene/import/source/confined_files.h"

namespace campuswalk::scene {

std::optional<DecodedImage> decode_picture(std::span<const std::uint8_t> bytes, std::string& reason) {
    auto image = decode_image(bytes, reason);
    if (!image) {
        reason = "cannot be decoded (" + reason + "); use PNG, JPEG or WebP";
    }
    return image;
}

std::optional<DecodedImage> read_picture(const SceneFolder& folder, const std::string& uri,
                                         std::string& reason) {
    const auto path = folder.find_picture(uri);
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
    return decode_picture(*bytes, reason);
}

}  // namespace campuswalk::scene
