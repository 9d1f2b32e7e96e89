#pragma once

#include <cstddef>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// An image of a sequence. All of one have the same size.
struct Frame {
    Image image;
    std::size_t number = 0;  ///< from 0
    double time = 0.0;       ///< seconds of the walk
};

/// Where the frames of a walk go, in order.
class FrameSink {
public:
    virtual ~FrameSink() = default;
    /// Throws std::runtime_error when it can't be kept.
    virtual void add(const Frame& frame) = 0;
    /// After the last; everything must be on disk when this returns.
    virtual void finish() = 0;
};

}  // namespace campuswalk::engine::render
