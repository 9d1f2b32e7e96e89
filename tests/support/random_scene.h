#pragma once

#include <memory>

#include "collision/geometry/triangle_mesh.h"
#include "collision/world/world.h"
#include "tests/support/dice.h"

/// Scenes and pieces of scenes that a seed decides on, metres.
namespace campuswalk::support {

/// A box, sphere, capsule or wheel from some centimetres to a metre and a half across.
collision::Shape random_solid(Dice& dice);
/// Any turn, within `reach` of the origin along each axis.
collision::Pose random_pose(Dice& dice, double reach);

/// A triangle near `at`; one in five is level, upright or has no area.
collision::Triangle random_triangle(Dice& dice, const collision::Vec3& at);
/// Triangles of very different sizes within `reach` of the origin; some share corners, some are there twice.
collision::TriangleMesh random_mesh(Dice& dice, int triangles, double reach);

/// Half the side of the grounds below, metres.
constexpr double kSoupHalf = 6.0;
constexpr double kRandomVillageHalf = 14.0;

/// Triangles and solids of all sizes at any angle on a floor within four walls.
std::unique_ptr<collision::World> make_soup(Dice& dice);

/// Rolling ground within a fence, with rooms, stairs, ramps, walls and furniture wherever they fall, through
/// each other too.
std::unique_ptr<collision::World> make_random_village(Dice& dice);

/// The lowest free place over one of some random points within `half` of the origin.
collision::Vec3 random_free_place(const collision::World& world, Dice& dice, double half);

}  // namespace campuswalk::support
