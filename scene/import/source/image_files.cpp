#include "scene/import/source/image_files.h"

#include "scene/import/source/confined_files.h"

namespace campuswalk::scene {

std::optional<DecodedImage> decode_image_bytes(std::span<const std::uint8_t> bytes, std::string& reason) {
    auto image = decode_image(bytes, reason);
    if (!image) {
        reason = "cannot be decoded (" + reason + "); use PNG, JPEG or WebP";
    }
    return image;
}

std::optional<DecodedImage> read_image(const SceneFolder& folder, const std::string& uri,
                                       std::string& reason) {
    const auto path = folder.find_image(uri);
    if (!path) {
        reason =
            "is missing or outside the folders a scene may read (its own and below, or textures/, "
            "materials/, images/, maps/ beside it)";
        return std::nullopt;
    }
    const auto bytes = read_bytes(*path);
    if (!bytes) {
        reason = "cannot be read";
        return std::nullopt;
    }
    return decode_image_bytes(*bytes, reason);
}

}  // namespace campuswalk::scene
