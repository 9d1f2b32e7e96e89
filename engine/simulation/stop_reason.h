#pragma once

#include <optional>

#include "engine/events/reason.h"
#include "engine/walkspace/stride/stride.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Where a body was stopped, and on its way to where.
struct StoppedBody {
    StrideSettings strides;
    collision::QueryFilter solids;
    GroundState at;
    collision::Vec3 heading = collision::Vec3::Zero();  ///< horizontal, of any length
};

/// Measured by walking near the place: what is in the way and how far one walks round it, or else what of the
/// body would have to change. None if nothing is in the way.
std::optional<Reason> reason_of_stop(const scene::Campus& campus, const StoppedBody& body);

/// From the edge of what, and where on that, a body fell that stood there last: the body's middle was beyond
/// the edge by then. None if nothing carries it there any more.
std::optional<Reason> reason_of_fall(const scene::Campus& campus, const StoppedBody& stood);

}  // namespace campuswalk::engine
