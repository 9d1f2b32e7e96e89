#pragma once

#include "engine/events/reason.h"
#include "engine/walkspace/route/route.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Why there is no route, or why none was found; see is_unsearched(). Takes seconds where the way is long to
/// look for.
Reason why_unreachable(const scene::Campus& campus, const RouteSettings& settings,
                       const RouteRequest& request, const NoRoute& none);

}  // namespace campuswalk::engine
