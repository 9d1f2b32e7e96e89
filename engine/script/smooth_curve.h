#pragma once

#include <vector>

#include <Eigen/Core>

namespace campuswalk::engine {

/// Replaces `out` by a polyline along the centripetal Catmull-Rom spline through the points' (x, z), y being
/// 0: it starts at the first, ends at the last, passes all of them in between, and makes neither loops nor
/// cusps where points lie close together. Its pieces are at most a decimetre of the straight way long, a
/// thousandth of it where points are more than 100 m apart. Points that repeat the one before are left out.
/// (Yuksel, Schaefer, Keyser: Parameterization and applications of Catmull-Rom curves, 2011.)
void smooth_curve(const std::vector<Eigen::Vector3d>& points, std::vector<Eigen::Vector3d>& out);

}  // namespace campuswalk::engine
