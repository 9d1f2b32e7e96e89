#pragma once

#include <string_view>

namespace campuswalk::scene {

/// Lists and objects of JSON that may lie in one another. Copying, printing and reading what is nested more
/// deeply takes as much stack.
constexpr int kDeepestJson = 64;

/// Whether JSON text is nested more deeply. Of text that isn't JSON, it counts at least as deep as a parser
/// gets before it notices.
bool is_nested_deeply(std::string_view json);

}  // namespace campuswalk::scene
