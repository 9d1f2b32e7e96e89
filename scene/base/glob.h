#pragma once

#include <string>
#include <string_view>

namespace campuswalk::scene {

/// Whether the whole name matches: `*` any characters, `?` one, `[a-z]` and `[!a-z]` one of a class, `\`
/// takes the next character as it is.
bool glob_matches(std::string_view glob, std::string_view name);

/// The glob that this name matches and no other.
std::string glob_for(std::string_view name);

}  // namespace campuswalk::scene
