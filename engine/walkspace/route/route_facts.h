#pragma once

#include <optional>

#include "collision/world/world.h"
#include "engine/script/route.h"
#include "engine/walkspace/stride/stride.h"

namespace campuswalk::engine {

/// What a route is like for those who take it.
struct RouteFacts {
    struct Spot {
        double value = 0.0;
        collision::Vec3 at = collision::Vec3::Zero();  ///< the feet there
    };
    /// Metres between what stands to the left and to the right, from above a step to the head; none if that
    /// is nowhere less than kWidest.
    std::optional<Spot> narrowest;
    Spot steepest;  ///< radians, of the ground's faces: treads of stairs are level

    static constexpr double kWidest = 3.0;
};

/// Looks at the path every few centimetres.
RouteFacts facts_of(const Route& route, const collision::World& world, const collision::MoverSettings& body,
                    const collision::QueryFilter& solids);

}  // namespace campuswalk::engine
