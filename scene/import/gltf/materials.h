#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/import/gltf/document.h"
#include "scene/import/source/model_source.h"

namespace campuswalk::scene::gltf {

/// How an image lies on a surface: by which texture coordinates, and what KHR_texture_transform makes of
/// them: uv' = linear * uv + offset.
struct TextureLayout {
    unsigned int channel = 0;
    Eigen::Matrix2f linear = Eigen::Matrix2f::Identity();
    Eigen::Vector2f offset = Eigen::Vector2f::Zero();

    bool operator==(const TextureLayout&) const = default;
};

struct GltfMaterial {
    SourceMaterial source;
    TextureLayout layout;               ///< of its first image
    std::vector<std::string> left_out;  ///< keys of images that lie otherwise than the first
};

/// All of a file's materials and, last, glTF's default one. Images inside the file are called `*N`, N being
/// the number in `images`.
std::vector<GltfMaterial> read_materials(const Document& document);

}  // namespace campuswalk::scene::gltf
