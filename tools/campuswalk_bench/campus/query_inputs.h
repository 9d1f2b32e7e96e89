#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

// The inputs of the queries that visitors of a campus cause; for a seed, they are the same on every machine.

inline constexpr double kEyeHeight = 1.6;     ///< metres
inline constexpr double kAvatarRadius = 0.3;  ///< metres
inline constexpr double kAvatarHeight = 1.8;  ///< metres

/// Rays of `length` metres from eye height above some of `feet`, uniformly distributed over all directions.
std::vector<collision::Ray> eye_rays(std::span<const collision::Vec3> feet, double length, std::size_t count,
                                     std::uint32_t seed);

/// The segments of upright avatars (radius kAvatarRadius, kAvatarHeight tall), most of which touch something.
std::vector<collision::Segment> avatars(const collision::TriangleMesh& mesh, std::size_t count,
                                        std::uint32_t seed);

}  // namespace campuswalk::tools::bench
