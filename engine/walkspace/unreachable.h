#pragma once

#include <optional>
#include <string>

#include "engine/walkspace/route.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Why there is no route, or why none was found.
struct UnreachableReason {
    /// Measured: "riser of 0.45 m at stair, 3.20, 0.45, -1.00; the avatar steps 0.30 m". A sentence without
    /// its full stop.
    std::string text;
    std::optional<collision::Vec3> at = {};  ///< where that is, if it is anywhere
    bool incomplete = false;                 ///< there may be one: not everything was searched
};

/// Takes seconds where the way is long to look for.
UnreachableReason why_unreachable(const scene::Campus& campus, const RouteSettings& settings,
                                  const RouteRequest& request, const NoRoute& none);

}  // namespace campuswalk::engine
