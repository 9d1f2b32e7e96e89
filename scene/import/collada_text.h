#pragma once

#include <cstdint>
#include <vector>

namespace campuswalk::scene {

/// Takes the white space out that follows an element's opening tag: assimp 5.2.5 refuses a COLLADA number
/// with a space before it, which XML allows and some exporters write.
void trim_element_starts(std::vector<std::uint8_t>& xml);

}  // namespace campuswalk::scene
