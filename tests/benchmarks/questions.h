#pragma once

#include <cstdint>
#include <vector>

#include "collision/mesh_collider.h"
#include "collision/ray.h"
#include "collision/shapes.h"

namespace campuswalk::bench {

// The same on every machine for a seed.

/// From eye height above whatever is there, in any direction, `length` metres long.
std::vector<collision::Ray> make_rays(const collision::MeshCollider& campus, double length, std::size_t count,
                                      std::uint32_t seed);

/// The segments of upright avatars (radius kAvatarRadius, 1.8 m tall), most of them in touch with something.
std::vector<collision::Segment> make_avatars(const collision::MeshCollider& campus, std::size_t count,
                                             std::uint32_t seed);

constexpr double kAvatarRadius = 0.3;  ///< metres
constexpr double kAvatarHeight = 1.8;  ///< metres

}  // namespace campuswalk::bench
