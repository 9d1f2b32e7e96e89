#pragma once

#include <cstdint>
#include <optional>

#include "collision/geometry/shapes.h"
#include "collision/mover/mover_settings.h"
#include "collision/world/world.h"

namespace campuswalk::engine {

/// What stops a body, and where it touches it.
struct OpposingContact {
    collision::ObjectId object{};
    std::uint32_t triangle = 0;
    collision::Vec3 at = collision::Vec3::Zero();  ///< on the object
};

/// Of what a body at `foot` touches or nearly touches, what opposes a move `ahead` (horizontal) most.
std::optional<OpposingContact> opposing_contact(const collision::World& world,
                                                const collision::QueryFilter& solids,
                                                const collision::MoverSettings& body,
                                                const collision::Vec3& foot, const collision::Vec3& ahead);

}  // namespace campuswalk::engine
