#pragma once

#include <vector>

#include <Eigen/Core>

#include "scene/import/gltf/document.h"
#include "scene/import/model_source.h"

namespace campuswalk::scene::gltf {

/// A material and how KHR_texture_transform lays its picture: uv' = linear * uv + offset.
struct GltfMaterial {
    SourceMaterial source;
    Eigen::Matrix2f uv_linear = Eigen::Matrix2f::Identity();
    Eigen::Vector2f uv_offset = Eigen::Vector2f::Zero();
};

/// All of a file's materials and, last, glTF's default one. Pictures inside the file are called `*N`, N being
/// the number in `images`.
std::vector<GltfMaterial> read_materials(const Document& document);

}  // namespace campuswalk::scene::gltf
