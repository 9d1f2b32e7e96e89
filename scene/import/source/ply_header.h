#pragma once

#include <istream>
#include <string>

namespace campuswalk::scene {

/// What is wrong with the size of a PLY file or its lists; empty if nothing is. Of a file that ends before
/// the elements that its header announces, assimp repeats the last one, up to billions of times.
std::string ply_fault(std::istream& in);

}  // namespace campuswalk::scene
