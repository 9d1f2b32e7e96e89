#pragma once

#include <functional>
#include <vector>

#include "collision/mover/mover_settings.h"
#include "engine/events/reason.h"
#include "engine/script/step.h"
#include "engine/walkspace/route/route.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Whether a body with its feet there is where it is to avoid: it touches one of the objects or is in it, or
/// its feet are within the radius of a point. Empty if nothing is avoided. The campus must outlive it.
std::function<bool(const collision::Vec3& foot)> keep_out_of(const scene::Campus& campus,
                                                             const std::vector<Avoided>& avoided,
                                                             const collision::MoverSettings& body);

/// Of a request without a route, while there is one if nothing is avoided: what of `settings.avoided` it
/// takes to close every way, so far as that is found out soon.
Reason why_avoided(const scene::Campus& campus, const RouteSettings& settings, const RouteRequest& request);

}  // namespace campuswalk::engine
