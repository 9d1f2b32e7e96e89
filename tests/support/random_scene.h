#pragma once

#include <memory>

#include "collision/geometry/triangle_mesh.h"
#include "collision/world/world.h"
#include "tests/support/dice.h"

/// Random scenes and parts of scenes, determined by a seed, metres.
namespace campuswalk::support {

/// A box, sphere, capsule or wheel from some centimetres to a metre and a half across.
collision::Shape random_solid(Dice& dice);
/// Any rotation, within `reach` of the origin along each axis.
collision::Pose random_pose(Dice& dice, double reach);

/// A triangle near `at`; one in five is level, upright or has no area.
collision::Triangle random_triangle(Dice& dice, const collision::Vec3& at);
/// Triangles of very different sizes within `reach` of the origin; some share vertices, some are duplicates.
collision::TriangleMesh random_mesh(Dice& dice, int triangles, double reach);

/// Half the side of the grounds below, metres.
constexpr double kSoupHalf = 6.0;
constexpr double kRandomVillageHalf = 14.0;

/// Triangles and solids of all sizes at any angle on a floor within four walls.
std::unique_ptr<collision::World> make_soup(Dice& dice);

/// Rolling ground within a fence, with rooms, stairs, ramps, walls and furniture at random places, even
/// through each other.
std::unique_ptr<collision::World> make_random_village(Dice& dice);

/// The lowest free place above a random point within `half` of the origin.
collision::Vec3 random_free_place(const collision::World& world, Dice& dice, double half);

}  // namespace campuswalk::support
