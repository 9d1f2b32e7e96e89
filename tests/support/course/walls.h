#pragma once

#include "tests/support/mesh_pieces.h"

/// Walls of the conformance course, as modellers make them: all in the plane z = 0 with their fronts
/// towards +Z, from x = -length to x = length, 3 m high.
namespace campuswalk::support {

/// One quad.
void add_plain_wall(collision::World& world, double length, const collision::Pose& X_world_wall);
/// Boxes of a metre side by side in one mesh, their hidden ends kept.
void add_butted_wall(collision::World& world, double length, const collision::Pose& X_world_wall);
/// Some 0.3 m wide triangles, rows shifted against each other (T-junctions).
void add_tessellated_wall(collision::World& world, double length, const collision::Pose& X_world_wall);
/// Flush sheets of 0.7 m, each a separate object.
void add_wall_of_sheets(collision::World& world, double length, const collision::Pose& X_world_wall);
/// Convex boxes of 2 m, flush.
void add_wall_of_boxes(collision::World& world, double length, const collision::Pose& X_world_wall);

/// A wedge of two sheets, `degrees` wide, its tip at (0, 0, 0), open towards -X, 8 m long.
void add_wedge(TriangleMesh& mesh, double degrees);
/// A wall of `thickness` (0: a sheet) across the path at `x`, with an opening of `width` around z = 0, `high`
/// metres high; closed above up to 3 m.
void add_doorway(TriangleMesh& mesh, double x, double thickness, double width, double high);
/// A sheet or a box from z = -`half` to `half` whose front is at `x`, from `low` to `high`.
void add_barrier(TriangleMesh& mesh, double x, double thickness, double half, double low, double high);

}  // namespace campuswalk::support
