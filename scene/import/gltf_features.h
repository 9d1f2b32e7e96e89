#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::scene {

bool is_gltf_name(const std::filesystem::path& path);

/// Something in a glTF file that assimp 5.2.5 passes over without a word.
struct IgnoredFeature {
    std::string name;    ///< an extension, or what there is too much of
    std::string effect;  ///< what is wrong with the result, and the cure
};

/// Those in a `.gltf` or `.glb` file; none for other formats. The JSON text is searched, not parsed.
std::vector<IgnoredFeature> ignored_gltf_features(const std::filesystem::path& path);

}  // namespace campuswalk::scene
