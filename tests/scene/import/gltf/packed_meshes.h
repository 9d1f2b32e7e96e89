#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/scene/import/gltf/gltf_text.h"

namespace campuswalk::scene::test {

/// A square of 1 x 1 m on the ground, facing up.
struct GridMesh {
    std::vector<float> positions;  ///< x, y, z
    std::vector<std::uint32_t> indices;
    std::vector<std::uint8_t> joints;  ///< empty, or four a vertex, of which the first has all the weight
};

/// `side` x `side` vertices.
GridMesh grid_mesh(std::size_t side);

/// The positions (attribute 0), joints and weights (1 and 2), and triangles, encoded by Draco.
std::vector<std::uint8_t> draco_of(const GridMesh& mesh);

std::vector<std::uint8_t> meshopt_vertices_of(const GridMesh& mesh);  ///< 12 bytes per vertex
std::vector<std::uint8_t> meshopt_indices_of(const GridMesh& mesh);   ///< 4 bytes per index

/// Files with one node called `packed`; meshopt's with a fallback buffer that has no data.
GltfText draco_gltf(const GridMesh& mesh);
GltfText meshopt_gltf(const GridMesh& mesh);

/// A lossless WebP file of one colour.
std::string webp_image(int width, int height, std::array<std::uint8_t, 4> rgba);

}  // namespace campuswalk::scene::test
