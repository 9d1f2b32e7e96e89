#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// Stands for a space in names of solids from normalize_stl().
inline constexpr char kStlSpace = '\x1E';

/// Changes an STL file so that assimp 5.2.5 reads it: of a binary one, bytes after its triangles are cut off;
/// of text, keywords become lower case, and spaces in the names of solids kStlSpace, as assimp cuts names
/// there.
void normalize_stl(std::vector<std::uint8_t>& stl);

/// A solid's name as the file has it.
std::string name_of_solid(std::string name);

}  // namespace campuswalk::scene
