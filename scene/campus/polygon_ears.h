#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// Triangles of a flat polygon, indices into its points: ear by ear (G. H. Meisters, "Polygons have ears",
/// 1975). `normal`: about which the points run counter-clockwise. Empty for fewer than three points, or if
/// the polygon crosses itself so that no ear is left.
std::vector<std::array<std::size_t, 3>> polygon_ears(const std::vector<Eigen::Vector3d>& points,
                                                     const Eigen::Vector3d& normal);

}  // namespace campuswalk::scene
