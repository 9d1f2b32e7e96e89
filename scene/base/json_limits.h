#pragma once

#include <string>
#include <string_view>

namespace campuswalk::scene {

/// Lists and objects of JSON that may lie in one another. Copying, printing and reading what is nested more
/// deeply takes as much stack.
constexpr int kDeepestJson = 64;

/// Members that an object of JSON may have. An ordered one looks each name up among all before it.
constexpr int kMostJsonMembers = 1000;

/// Which of these limits JSON text is beyond, as a sentence without its full stop; empty if it keeps both. Of
/// text that isn't JSON, it looks at as much at least as a parser does before it notices.
std::string why_too_complex(std::string_view json);

}  // namespace campuswalk::scene
