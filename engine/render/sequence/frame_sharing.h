#pragma once

#include <cstddef>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// Supplies the frames that other processes draw.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// Waits for the frame. Called in order. Throws std::runtime_error if it will never arrive.
    virtual Frame take(std::size_t number) = 0;
};

/// The frames that this process draws if several play the same walk: those with number % parts == part.
struct SequenceShare {
    std::size_t part = 0;
    std::size_t parts = 1;

    bool has(std::size_t number) const { return number % parts == part; }
};

}  // namespace campuswalk::engine::render
