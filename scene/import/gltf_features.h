#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::scene {

bool is_gltf_name(const std::filesystem::path& path);

/// A glTF extension that assimp 5.2.5 passes over without a word.
struct IgnoredFeature {
    std::string extension;
    std::string effect;
};

/// Those that a `.gltf` or `.glb` file names; none for other formats. Only the JSON text is searched.
std::vector<IgnoredFeature> ignored_gltf_features(const std::filesystem::path& path);

}  // namespace campuswalk::scene
