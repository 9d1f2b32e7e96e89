#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// What is wrong with the size of a PLY file or its lists; empty if nothing is. Of a file that ends before
/// the elements that its header announces, assimp repeats the last one, up to billions of times.
std::string ply_fault(std::istream& in);

/// A PLY file without ply_fault, written so that assimp 5.2.5 understands it: without comments, which end an
/// element for it, and without elements before and between vertices and faces; binary data begin with no line
/// end, which it skips. Empty if it understands the file as it is.
std::vector<std::uint8_t> rewrite_ply(std::istream& in);

}  // namespace campuswalk::scene
