#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tools/campuswalk/run/workers/worker.h"

namespace campuswalk::tools {

/// Processes that draw a share of the frames of the walk that this one plays, and end with this object. They
/// play the walk, too, which is the same everywhere: sending what a frame shows would take more.
class FrameHelpers {
public:
    static constexpr std::size_t kMaxParts = 8;  ///< each holds the driver's copy of the campus

    /// Draws one part of the frames, in a process of its own: sends each as Topic::frame, and at the end an
    /// error message as Topic::result, which is empty if all went well. Throws nothing.
    using Draw = std::function<void(std::size_t part, const Send& send)>;

    /// Part 0 is this process. Must be made before it draws anything, as drivers don't survive a fork. Throws
    /// std::runtime_error when no process can be started.
    FrameHelpers(std::size_t parts, const Draw& draw);

    std::size_t parts() const { return helpers_.size() + 1; }

    /// Waits for the next frame of a part other than 0 and returns it as it was sent. Throws
    /// std::runtime_error when there is none.
    std::string next_frame(std::size_t part);

private:
    std::vector<Worker> helpers_;  ///< of parts 1, 2, …
};

}  // namespace campuswalk::tools
