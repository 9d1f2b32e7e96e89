#pragma once

#include <span>
#include <vector>

#include "collision/mover/contact_cache.h"
#include "collision/mover/half_planes.h"
#include "collision/mover/mover_settings.h"
#include "collision/mover/sphere_rest.h"

namespace campuswalk::collision {

/// Lists that are reused so that a warm move allocates nothing. Each user clears a list before filling it.
struct MoveBuffers {
    struct Rest {
        ContactCache::Index piece = 0;
        SphereRest sphere;
    };
    std::vector<Rest> rests;
    std::vector<HalfPlane> walls;
    std::vector<ContactCache::Index> edges;
};

/// What the stages of one move work on.
struct MoveContext {
    const MoverSettings& body;
    double steepest = 0.0;   ///< metres up per metre ahead
    ContactCache& contacts;  ///< retained from earlier moves
    MoveBuffers& buffers;
    std::span<const ContactCache::Index>
        near;  ///< the surveyed pieces: all that the body may come near in this part of the move
};

}  // namespace campuswalk::collision
