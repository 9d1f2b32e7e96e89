#include "scene/import/gltf_features.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace campuswalk::scene {
namespace {

struct KnownFeature {
    std::string_view extension;
    std::string_view effect;
};

constexpr std::array<KnownFeature, 2> kIgnored = {{
    {"EXT_mesh_gpu_instancing", "copies that it places are missing; export without GPU instancing"},
    {"KHR_texture_transform", "textures may sit or repeat wrongly; apply texture transforms before export"},
}};

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// The file's JSON: all of a .gltf, the first chunk of a .glb.
std::string json_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (lower_extension(path) == ".gltf") {
        return {std::istreambuf_iterator<char>(in), {}};
    }
    constexpr std::streamoff kChunkLength = 12;
    constexpr std::streamoff kChunkData = 20;
    constexpr std::uint32_t kMostJson = 256U << 20U;
    in.seekg(kChunkLength);
    std::array<unsigned char, 4> length{};
    in.read(reinterpret_cast<char*>(length.data()), length.size());
    const std::uint32_t size = length[0] | static_cast<std::uint32_t>(length[1]) << 8U |
                               static_cast<std::uint32_t>(length[2]) << 16U |
                               static_cast<std::uint32_t>(length[3]) << 24U;
    in.seekg(kChunkData);
    if (!in || size > kMostJson) {
        return {};
    }
    std::string text(size, '\0');
    in.read(text.data(), static_cast<std::streamsize>(size));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return text;
}

}  // namespace

bool is_gltf_name(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    return extension == ".gltf" || extension == ".glb";
}

std::vector<IgnoredFeature> ignored_gltf_features(const std::filesystem::path& path) {
    std::vector<IgnoredFeature> found;
    if (!is_gltf_name(path)) {
        return found;
    }
    const std::string text = json_text(path);
    for (const KnownFeature& feature : kIgnored) {
        if (text.find('"' + std::string(feature.extension) + '"') != std::string::npos) {
            found.push_back({std::string(feature.extension), std::string(feature.effect)});
        }
    }
    return found;
}

}  // namespace campuswalk::scene
