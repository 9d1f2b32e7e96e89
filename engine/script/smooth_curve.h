#pragma once

#include <vector>

#include <Eigen/Core>

namespace campuswalk::engine {

/// Replaces `out` by a polyline along the centripetal Catmull-Rom spline through the points' (x, z), with
/// y = 0: it starts at the first, ends at the last, passes through all of them in between, and has neither
/// loops nor cusps where points are close together. Two points have a segment for each decimetre of their
/// straight distance, but at most a thousand. Points that repeat the previous one are left out. (Yuksel,
/// Schaefer, Keyser: Parameterization and applications of Catmull-Rom curves, 2011.)
void smooth_curve(const std::vector<Eigen::Vector3d>& points, std::vector<Eigen::Vector3d>& out);

}  // namespace campuswalk::engine
