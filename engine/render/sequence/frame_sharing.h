#pragma once

#include <cstddef>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// Where the frames come from that others draw.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// Waits for it. Asked for in order. Throws std::runtime_error when it will never be there.
    virtual Frame take(std::size_t number) = 0;
};

/// Which frames of a walk are drawn here, of several processes that each play it: those whose number leaves
/// the remainder `part` when it is divided by `parts`.
struct FrameShare {
    std::size_t part = 0;
    std::size_t parts = 1;

    bool has(std::size_t number) const { return number % parts == part; }
};

}  // namespace campuswalk::engine::render
