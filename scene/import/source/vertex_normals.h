#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// Normals for a mesh that came without: three a triangle, in the order of its corners, unit length.
/// Faces that meet at a position and whose normals differ by at most the crease angle are smoothed together,
/// weighted by area; a corner with a sharper edge keeps its own. `crease_cosine` 1 gives flat shading.
/// A triangle without an area gets +Y.
std::vector<Eigen::Vector3f> vertex_normals(std::span<const Eigen::Vector3f> positions,
                                            std::span<const std::array<std::uint32_t, 3>> triangles,
                                            double crease_cosine);

/// Unit normal of one triangle, +Y when it has no area.
Eigen::Vector3f face_normal(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c);

}  // namespace campuswalk::scene
