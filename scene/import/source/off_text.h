#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace campuswalk::scene {

/// What is wrong with an OFF file for assimp 5.2.5, which leaves out faces of more than nine vertices without
/// a word; empty if nothing is.
std::string fault_of_off(std::span<const std::uint8_t> off);

}  // namespace campuswalk::scene
