#pragma once

#include <vector>

#include <Eigen/Core>

#include "tests/support/mesh_pieces.h"

/// Ground whose height depends on x alone, and how a ball rolls over it: the conformance course's oracle for
/// everything underfoot.
namespace campuswalk::support {

/// (x, y) in metres, x never decreasing; two points with the same x are a riser.
using Profile = std::vector<Eigen::Vector2d>;

/// Level from 8 m before `x`, `steps` risers of one height, level for 8 m behind the last.
Profile flight(double x, double riser, double tread, int steps);
/// Level, then `run` metres at `degrees`, then level for 8 m.
Profile ramp(double x, double degrees, double run);
/// Waves of `length` and `height` (crest over trough), each of `pieces` straight pieces, between level ends.
Profile waves(double length, double height, int count, int pieces);

/// The surface, 2 * `half_width` wide; facets face up.
void add_profile(TriangleMesh& mesh, const Profile& profile, double half_width);

/// The lowest a ball of `radius` can be over `x` without overlapping the profile: the height of its lowest
/// point. In closed form for each piece, sharing nothing with the mover.
double rolled_height(const Profile& profile, double x, double radius);

}  // namespace campuswalk::support
