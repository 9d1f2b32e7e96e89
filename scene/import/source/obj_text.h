#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// Coordinates of a map may be hundreds of kilometres from its origin, where the float32 that assimp reads
/// them into has steps of centimetres. Moves the vertices of OBJ text near the origin and gives by how much,
/// whole units: a vertex was at the sum of both. Zero, with nothing changed, where steps are below half a
/// millimetre, where moving wouldn't halve them, and where a vertex isn't plainly written.
Eigen::Vector3d move_vertices_near(std::vector<std::uint8_t>& obj, double metres_per_unit);

/// Faces may name texture coordinates although the text has none; assimp 5.2.5 makes points of such a face.
/// Takes these numbers out; false, with nothing changed, where that isn't so.
bool drop_absent_uvs(std::vector<std::uint8_t>& obj);

}  // namespace campuswalk::scene
