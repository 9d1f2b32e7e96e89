#pragma once

#include <functional>
#include <string_view>

namespace campuswalk::engine {

/// Takes a line without its end. Throws std::runtime_error if it can't be written.
using LineSink = std::function<void(std::string_view line)>;

}  // namespace campuswalk::engine
