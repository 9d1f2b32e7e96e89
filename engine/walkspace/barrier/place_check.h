#pragma once

#include <optional>

#include "engine/events/reason.h"
#include "engine/walkspace/stride/stride.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Whether a body could stand at a point, whatever the way there: where, or else why not.
struct PlaceCheck {
    std::optional<GroundState> ground;
    Reason problem = {};  ///< without the place
};

PlaceCheck check_place(const scene::Campus& campus, Strider& strider, const collision::Vec3& point);

}  // namespace campuswalk::engine
