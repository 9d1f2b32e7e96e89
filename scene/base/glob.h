#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace campuswalk::scene {

/// Whether the glob matches the whole name: `*` any characters, `?` one, `[a-z]` and `[!a-z]` one of a class;
/// `\` escapes the next character.
bool glob_matches(std::string_view glob, std::string_view name);
/// Adds to `compared` the characters of the glob that were looked at, each as often as it was: up to the
/// product of both lengths.
bool glob_matches(std::string_view glob, std::string_view name, std::uint64_t& compared);

/// The name with special characters escaped: a glob that matches it and nothing else. Control characters and
/// bytes that aren't UTF-8, which no file may have, become `?`.
std::string glob_for(std::string_view name);

}  // namespace campuswalk::scene
