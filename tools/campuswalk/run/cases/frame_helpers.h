#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tools/campuswalk/run/workers/worker.h"

namespace campuswalk::tools {

/// Processes that draw a share of the frames of the walk that this one plays, and end with this object. They
/// play it, too: what is to be seen in a frame would be more to say, and a walk is the same wherever it is
/// played.
class FrameHelpers {
public:
    static constexpr std::size_t kMostParts = 8;  ///< each holds what the driver makes of the campus

    /// Draws one part of the frames, in a process of its own: says each as Topic::frame, and in the end what
    /// went wrong as Topic::result, which is empty when nothing did. Throws nothing.
    using Draw = std::function<void(std::size_t part, const Say& say)>;

    /// Part 0 is this process. To be made before it draws anything, as drivers don't survive a fork. Throws
    /// std::runtime_error when the system has no room.
    FrameHelpers(std::size_t parts, const Draw& draw);

    std::size_t parts() const { return helpers_.size() + 1; }

    /// The next frame of a part other than 0, as it was said; waits for it. Throws std::runtime_error when
    /// there is none.
    std::string next_frame(std::size_t part);

private:
    std::vector<Worker> helpers_;  ///< of part 1 and so on
};

}  // namespace campuswalk::tools
