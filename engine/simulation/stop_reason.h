#pragma once

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

/// Why it doesn't get on, measured by walking near the place: what is in the way and how far one walks round
/// it, or else what of the body would have to change. Empty if nothing is in the way.
std::string reason_of_stop(const scene::Campus& campus, const StoppedBody& body);

}  // namespace campuswalk::engine
