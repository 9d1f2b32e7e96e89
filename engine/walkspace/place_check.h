#pragma once

#include <optional>
#include <string>

#include "engine/walkspace/stride.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Whether a body could stand at a point, whatever the way there: where, or why not ("it is inside library").
struct PlaceCheck {
    std::optional<GroundState> ground;
    std::string problem;
};

PlaceCheck check_place(const scene::Campus& campus, Strider& strider, const collision::Vec3& point);

}  // namespace campuswalk::engine
