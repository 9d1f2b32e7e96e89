#pragma once

#include <stdexcept>

namespace campuswalk::engine::render {

/// Rendering isn't possible on this machine or at this size; the message says what to install or change.
class RenderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace campuswalk::engine::render
