#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "collision/mover/contact_cache.h"
#include "collision/mover/half_planes.h"
#include "collision/mover/mover_settings.h"
#include "collision/mover/sphere_rest.h"

namespace campuswalk::collision {

/// What a body that stands at one place might come to rest on if it went a little aside.
struct GroundCandidates {
    static constexpr std::size_t kLanes = 8;
    using Lanes = std::array<float, kLanes>;
    /// The bounds of eight pieces about the place, metres. What lies beyond the body's reach is cut off.
    struct Boxes {
        Lanes min_x{}, max_x{}, min_z{}, max_z{}, low{}, top{};
    };
    std::vector<Boxes> boxes;
    std::vector<ContactCache::Index> pieces;
    std::vector<std::uint32_t> chosen;  ///< for one search, indices into `pieces`
    /// The place, and the height that edges are measured from there; none until the lists are filled.
    std::optional<Vec3> foot;
    double base = 0.0;
    std::optional<ContactCache::Index> highest;  ///< in the last search: likely also in the next
};

/// Lists that are reused so that a warm move allocates nothing. Each user clears a list before filling it.
struct MoveBuffers {
    struct Rest {
        ContactCache::Index piece = 0;
        SphereRest sphere;
    };
    /// Whether a floor ends at a point.
    struct FloorEnd {
        Vec3 point = Vec3::Zero();
        bool is_there = false;
    };
    std::vector<Rest> rests;
    std::optional<FloorEnd> floor_end;  ///< the last that was looked for since the survey
    GroundCandidates ground;            ///< among the surveyed pieces
    std::vector<HalfPlane> walls;
    std::vector<ContactCache::Index> edges;
    std::vector<Vec3> sides;  ///< horizontal normals of what is beside a body that falls
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
