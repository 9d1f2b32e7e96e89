#pragma once

#include <cstddef>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// An image of a sequence. All frames of a sequence have the same size.
struct Frame {
    Image image;
    std::size_t number = 0;  ///< from 0
    double time = 0.0;       ///< simulated seconds
};

/// Receives the frames of a walk in order.
class FrameSink {
public:
    virtual ~FrameSink() = default;
    /// Throws std::runtime_error if it can't be written.
    virtual void add(const Frame& frame) = 0;
    /// Called after the last frame; everything must be on disk on return.
    virtual void finish() = 0;
};

}  // namespace campuswalk::engine::render
