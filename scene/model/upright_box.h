#pragma once

#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// A box with a level floor, turned about +Y.
struct UprightBox {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d size = Eigen::Vector3d::Zero();    ///< along `along`, up, and across
    Eigen::Vector3d along = Eigen::Vector3d::UnitX();  ///< unit, level
    Eigen::Vector3d across() const { return {-along.z(), 0.0, along.x()}; }  ///< +Z for +X

    /// How far inside of the nearest wall, floor or ceiling a point is; negative outside.
    double depth_of(const Eigen::Vector3d& point) const;
};

/// Collects points for the smallest upright box about them.
class UprightBoxFit {
public:
    void add(const Eigen::Vector3d& point);
    bool empty() const { return low_ > high_; }

    /// The one with least ground, if that is a tenth less than what the axes' box covers; else that. `along`
    /// then lies within 45 degrees of +X. A size may be 0.
    UprightBox box();

private:
    std::vector<Eigen::Vector2d> plan_;  ///< x, z: the hull so far and what came since
    std::size_t next_hull_ = 1024;
    double low_ = 1e300;
    double high_ = -1e300;
};

/// Convex hull, counter-clockwise for x to the right and y up, without points on its edges.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

}  // namespace campuswalk::scene
