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

constexpr std::array<KnownFeature, 2> kIgnoredExtensions = {{
    {"EXT_mesh_gpu_instancing",
     "ignored, the copies that it places are missing; export without GPU instancing"},
    {"KHR_texture_transform",
     "ignored, textures may sit or repeat wrongly; apply texture transforms before export"},
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

/// The number of objects in the array that follows the key, 0 when there is none.
std::size_t count_objects(const std::string& json, const std::string& key) {
    const std::size_t at = json.find('"' + key + '"');
    const std::size_t open =
        at == std::string::npos ? at : json.find_first_not_of(": \t\r\n", at + key.size() + 2);
    if (open == std::string::npos || json[open] != '[') {
        return 0;
    }
    std::size_t count = 0;
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = open; i < json.size(); ++i) {
        if (json[i] == '"' && json[i - 1] != '\\') {
            in_string = !in_string;
        } else if (!in_string && (json[i] == '[' || json[i] == '{')) {
            count += json[i] == '{' && depth == 1 ? 1U : 0U;
            ++depth;
        } else if (!in_string && (json[i] == ']' || json[i] == '}') && --depth == 0) {
            break;
        }
    }
    return count;
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
    for (const KnownFeature& feature : kIgnoredExtensions) {
        if (text.find('"' + std::string(feature.extension) + '"') != std::string::npos) {
            found.push_back({std::string(feature.extension), std::string(feature.effect)});
        }
    }
    if (const std::size_t scenes = count_objects(text, "scenes"); scenes > 1) {
        found.push_back(
            {std::to_string(scenes) + " scenes", "only the default one is read; export one scene a file"});
    }
    return found;
}

}  // namespace campuswalk::scene
