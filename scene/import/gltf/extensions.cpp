#include "scene/import/gltf/extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/import/gltf/fault.h"

namespace campuswalk::scene::gltf {
namespace {

// Read here, one way or the other; images that aren't read are told of where a material needs one.
constexpr std::array<std::string_view, 11> kRead = {
    "CESIUM_RTC",         "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression", "EXT_texture_avif",
    "EXT_texture_webp",   "KHR_draco_mesh_compression", "KHR_mesh_quantization",   "KHR_meshopt_compression",
    "KHR_texture_basisu", "KHR_texture_transform",      "MSFT_texture_dds"};

// Sheen, lights, animation, metadata, which triangles were one polygon: nothing that a walk or its images
// know of.
constexpr std::array<std::string_view, 9> kHarmless = {"KHR_materials_", "KHR_lights_", "EXT_lights_",
                                                       "KHR_animation_", "KHR_xmp",     "KHR_audio",
                                                       "EXT_materials_", "MSFT_audio",  "FB_ngon_encoding"};

bool is_read(const std::string& name) {
    return std::ranges::find(kRead, name) != kRead.end() ||
           std::ranges::any_of(kHarmless, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

}  // namespace

void check_version_and_extensions(const Document& document) {
    const auto asset = document.root().object("asset");
    if (!asset) {
        throw Fault("it has no 'asset', so it is not glTF");
    }
    const std::string version = asset->text("version");
    if (!version.starts_with("2.")) {
        throw Fault("it is glTF version '" + version +
                    "'; only version 2 is supported: convert it to glTF 2.0");
    }
    for (const std::string& name : document.root().texts("extensionsRequired")) {
        if (!is_read(name)) {
            throw Fault("it requires the extension " + name + ", which is not supported; export without it");
        }
    }
}

std::vector<std::string> unread_extensions(const Document& document) {
    std::vector<std::string> unread;
    for (const std::string& name : document.root().texts("extensionsUsed")) {
        if (!is_read(name)) {
            unread.push_back(name);
        }
    }
    return unread;
}

}  // namespace campuswalk::scene::gltf
