#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// Between an object's name and its number in text from normalize_obj.
inline constexpr char kObjectNumber = '\x1F';

/// Writes OBJ text so that assimp 5.2.5 understands it, in one pass: without a byte order mark and comments,
/// with lines that continue joined, and `.5` as `0.5`. Each `o` and `g` becomes a `g` with a name of its own,
/// name, kObjectNumber and a number, as assimp puts the faces of a name that is there again elsewhere and
/// cuts names of `o` at a space. Returns what is wrong with the text; empty if nothing is.
std::string normalize_obj(std::vector<std::uint8_t>& obj);

/// Map coordinates may be hundreds of kilometres from the origin, where assimp's float32 has a spacing of
/// centimetres. Subtracts an offset in whole units from all vertices of OBJ text and returns it. Returns zero
/// and changes nothing if the spacing is below 0.5 mm, if the offset would not halve it, or if a vertex line
/// has an unusual form (weights, continuation lines).
Eigen::Vector3d move_vertices_near(std::vector<std::uint8_t>& obj, double metres_per_unit);

/// If faces refer to texture coordinates but the text has none, removes the references (assimp 5.2.5 turns
/// such faces into points) and returns true; else changes nothing.
bool drop_absent_uvs(std::vector<std::uint8_t>& obj);

}  // namespace campuswalk::scene
