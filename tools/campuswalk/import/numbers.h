#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// Exactly so many numbers with commas between. Throws scene::InputError about `option`.
std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::string& option);

}  // namespace campuswalk::tools
