#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/import/gltf/document.h"
#include "scene/import/source/model_source.h"

namespace campuswalk::scene::gltf {

/// The mapping of an image to a surface: the set of texture coordinates and KHR_texture_transform,
/// uv' = linear * uv + offset.
struct TextureLayout {
    unsigned int channel = 0;
    Eigen::Matrix2f linear = Eigen::Matrix2f::Identity();
    Eigen::Vector2f offset = Eigen::Vector2f::Zero();

    bool operator==(const TextureLayout&) const = default;
};

struct GltfMaterial {
    SourceMaterial source;
    TextureLayout layout;                     ///< of the first image
    std::vector<std::string> ignored_images;  ///< keys of images with another layout than the first
};

/// The file's materials and, last, glTF's default material. Embedded images are named `*N` by their index in
/// `images`.
std::vector<GltfMaterial> read_materials(const Document& document);

}  // namespace campuswalk::scene::gltf
