#include "scene/import/gltf/extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace campuswalk::scene::gltf {
namespace {

// Includes image formats that can't be decoded: those are reported for the materials that use them.
constexpr std::array<std::string_view, 12> kSupported = {
    "CESIUM_RTC",          "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression", "EXT_texture_avif",
    "EXT_texture_webp",    "KHR_draco_mesh_compression", "KHR_mesh_quantization",   "KHR_meshopt_compression",
    "KHR_node_visibility", "KHR_texture_basisu",         "KHR_texture_transform",   "MSFT_texture_dds"};

// Prefixes of extensions that change neither a walk nor its images: sheen, lights, animation, metadata.
constexpr std::array<std::string_view, 9> kIgnorable = {"KHR_materials_", "KHR_lights_", "EXT_lights_",
                                                        "KHR_animation_", "KHR_xmp",     "KHR_audio",
                                                        "EXT_materials_", "MSFT_audio",  "FB_ngon_encoding"};

bool is_supported(const std::string& name) {
    return std::ranges::find(kSupported, name) != kSupported.end() ||
           std::ranges::any_of(kIgnorable, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

}  // namespace

void check_version_and_extensions(const Document& document) {
    const auto asset = document.root().object("asset");
    if (!asset) {
        throw GltfError("it has no 'asset', so it is not glTF");
    }
    const std::string version = asset->string("version");
    if (!version.starts_with("2.")) {
        throw GltfError("it is glTF version '" + version +
                        "'; only version 2 is supported: convert it to glTF 2.0");
    }
    for (const std::string& name : document.root().strings("extensionsRequired")) {
        if (!is_supported(name)) {
            throw GltfError("it requires the extension " + name +
                            ", which is not supported; export without it");
        }
    }
    unread_extensions(document);  // throws unless they are names
}

std::vector<std::string> unread_extensions(const Document& document) {
    std::vector<std::string> unsupported;
    for (const std::string& name : document.root().strings("extensionsUsed")) {
        if (!is_supported(name)) {
            unsupported.push_back(name);
        }
    }
    return unsupported;
}

}  // namespace campuswalk::scene::gltf
