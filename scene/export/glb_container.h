#pragma once

#include <span>
#include <string>

namespace campuswalk::scene {

/// A GLB file of its JSON and of its binary chunk, whose parts follow one another; the length of each is a
/// multiple of four bytes. Throws std::runtime_error if the file would be larger than the format allows.
std::string glb_container(std::string json, std::span<const std::string> bin);

}  // namespace campuswalk::scene
