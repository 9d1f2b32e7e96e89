#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// Triangles from a reader in the frame of their node, not validated.
struct RawMesh {
    std::string name;
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;             ///< empty or one per position, of any length
    std::vector<Eigen::Vector2f> uvs;                 ///< empty or one per position; v points down
    std::vector<std::array<std::uint8_t, 4>> colors;  ///< empty or one per position; linear RGBA
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t material = 0;          ///< index into the reader's materials
    std::size_t points_and_lines = 0;  ///< other primitives, which are dropped
};

struct SanitizedMesh {
    Mesh mesh;  ///< without unused vertices; its material isn't set
    bool index_out_of_range = false;
    bool position_not_finite = false;
    std::size_t repaired_normals = 0;  ///< zero or not finite; replaced by the face normal
    std::size_t repaired_uvs = 0;      ///< not finite; set to 0
};

/// Validates and repairs a mesh: normalizes normals or generates them (flat, or smooth with creases), removes
/// unused vertices, and welds identical ones if no triangles share vertices. If one of the two errors is set,
/// the mesh is empty.
SanitizedMesh sanitize_mesh(RawMesh source, bool flat_normals);

/// A colour of floats in 0..1, clamped; NaN becomes 0.
std::array<std::uint8_t, 4> to_rgba8(float red, float green, float blue, float alpha);

}  // namespace campuswalk::scene
