#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// Generates unit normals for a mesh without: three per triangle, in the order of its indices. Each is the
/// area-weighted mean of the triangle's normal and of those adjacent at the vertex within the crease angle.
/// `crease_cosine` 1 gives flat shading. Degenerate triangles get +Y.
std::vector<Eigen::Vector3f> vertex_normals(std::span<const Eigen::Vector3f> positions,
                                            std::span<const std::array<std::uint32_t, 3>> triangles,
                                            double crease_cosine);

/// Unit normal of a triangle, +Y if it is degenerate.
Eigen::Vector3f face_normal(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c);

}  // namespace campuswalk::scene
