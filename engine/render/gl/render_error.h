#pragma once

#include <stdexcept>

namespace campuswalk::engine::render {

/// Images can't be drawn on this machine or at this size; the message says what to install or change.
class RenderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace campuswalk::engine::render
