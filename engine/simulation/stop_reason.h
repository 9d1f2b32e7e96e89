#pragma once

#include <optional>
#include <string>

#include "engine/walkspace/stride.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Where a body was stopped, and on its way to where.
struct StoppedBody {
    StrideSettings strides;
    collision::QueryFilter solids;
    GroundState at;
    collision::Vec3 heading = collision::Vec3::Zero();  ///< horizontal, of any length
};

/// Why a body doesn't get on.
struct StopReason {
    std::string text;                        ///< without a full stop; empty if nothing is in the way
    std::optional<collision::Vec3> at = {};  ///< on what is in the way
};

/// Measured by walking near the place: what is in the way and how far one walks round it, or else what of the
/// body would have to change.
StopReason reason_of_stop(const scene::Campus& campus, const StoppedBody& body);

/// From the edge of what, and at which height, a body fell that stood there last, and where on that it stood:
/// the body's middle was beyond the edge by then. Its text is empty if nothing carries it there any more.
StopReason reason_of_fall(const scene::Campus& campus, const StoppedBody& stood);

}  // namespace campuswalk::engine
