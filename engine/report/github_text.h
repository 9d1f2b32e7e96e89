#pragma once

#include <string>
#include <string_view>

namespace campuswalk::engine {

/// The message of a command to GitHub; in its properties, colons and commas are escaped too. Lines stay
/// apart.
std::string github_escaped(std::string_view text, bool in_property);

}  // namespace campuswalk::engine
