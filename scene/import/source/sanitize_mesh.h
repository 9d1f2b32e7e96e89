#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// Triangles as a reader hands them over, in the frame of their node. Nothing about them has been checked.
struct RawMesh {
    std::string name;
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;             ///< empty or one a position, of any length
    std::vector<Eigen::Vector2f> uvs;                 ///< empty or one a position; v runs down
    std::vector<std::array<std::uint8_t, 4>> colors;  ///< empty or one a position; linear RGBA
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t material = 0;          ///< index into the reader's materials
    std::size_t points_and_lines = 0;  ///< what was in it beside triangles, and is dropped
};

struct SanitizedMesh {
    Mesh mesh;  ///< no vertex that no triangle uses; its material isn't set
    bool index_out_of_range = false;
    bool position_not_finite = false;
    std::size_t repaired_normals = 0;  ///< zero or not finite in the file, taken from the face instead
    std::size_t repaired_uvs = 0;      ///< not finite in the file, set to 0
};

/// Checks a mesh and makes it whole: unit normals (made where there are none, flat as glTF demands or
/// creased), and vertices that are equal to the bit joined when every corner came with its own. When one of
/// the two errors is set the mesh is empty.
SanitizedMesh sanitize_mesh(RawMesh source, bool flat_normals);

/// Swaps the winding of every triangle.
void flip_winding(Mesh& mesh);

}  // namespace campuswalk::scene
