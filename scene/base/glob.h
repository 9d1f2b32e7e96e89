#pragma once

#include <string>
#include <string_view>

namespace campuswalk::scene {

/// Whether the glob matches the whole name: `*` any characters, `?` one, `[a-z]` and `[!a-z]` one of a class;
/// `\` escapes the next character.
bool glob_matches(std::string_view glob, std::string_view name);

/// The name with special characters escaped: a glob that matches it and nothing else.
std::string glob_for(std::string_view name);

}  // namespace campuswalk::scene
