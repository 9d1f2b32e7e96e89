#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "collision/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// A mesh as a GLB file of one node. Throws std::runtime_error if it can't be written.
/// `normals`: one a position, or none.
void write_glb(const std::filesystem::path& file, const collision::TriangleMesh& mesh,
               std::span<const Eigen::Vector3f> normals);

/// Unit normals of the positions, each the mean of those of the triangles around it, by area.
std::vector<Eigen::Vector3f> smooth_normals(const collision::TriangleMesh& mesh);

}  // namespace campuswalk::tools::bench
