#pragma once

#include <cstddef>

#include "scene/model.h"

struct aiMesh;

namespace campuswalk::scene {

struct MeshStyle {
    bool flat_normals = false;    ///< shading when normals are missing: flat as glTF demands, else creased
    unsigned int uv_channel = 0;  ///< the one that the material's texture is laid out in
};

struct ConvertedMesh {
    Mesh mesh;  ///< triangles only (points and lines dropped), no vertex that no triangle uses; no material
    bool index_out_of_range = false;
    bool position_not_finite = false;
    std::size_t points_and_lines = 0;  ///< faces with fewer than three corners, dropped
    std::size_t repaired_normals = 0;  ///< zero or not finite in the file, taken from the face instead
    std::size_t repaired_uvs = 0;      ///< not finite in the file, set to 0
};

/// Copies an aiMesh whose polygons have been triangulated, joining vertices that are equal to the bit when
/// the importer gave every corner its own. When one of the two errors is set the mesh is empty.
ConvertedMesh convert_mesh(const aiMesh& source, const MeshStyle& style);

/// Swaps the winding of every triangle.
void flip_winding(Mesh& mesh);

}  // namespace campuswalk::scene
