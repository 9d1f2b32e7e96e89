#pragma once

#include <span>
#include <vector>

#include "collision/mover/contact_cache.h"
#include "collision/mover/half_planes.h"
#include "collision/mover/mover_settings.h"
#include "collision/mover/sphere_rest.h"

namespace campuswalk::collision {

/// Room for lists, so that a warm move allocates nothing. Whoever fills one empties it first.
struct MoveBuffers {
    struct Rest {
        ContactCache::Index piece = 0;
        SphereRest ball;
    };
    std::vector<Rest> rests;
    std::vector<HalfPlane> walls;
    std::vector<ContactCache::Index> edges;
};

/// What the stages of one move work on, handed from each to the next.
struct MoveContext {
    const MoverSettings& body;
    double steepest = 0.0;   ///< metres up for one metre ahead
    ContactCache& contacts;  ///< what is kept of earlier moves
    MoveBuffers& buffers;
    std::span<const ContactCache::Index> near;  ///< the pieces that the body may come near in this part of it
};

}  // namespace campuswalk::collision
