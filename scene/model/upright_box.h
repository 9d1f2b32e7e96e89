#pragma once

#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// An oriented box that is rotated about +Y only.
struct UprightBox {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d size = Eigen::Vector3d::Zero();    ///< along `along`, +Y and across()
    Eigen::Vector3d along = Eigen::Vector3d::UnitX();  ///< unit, horizontal
    Eigen::Vector3d across() const { return {-along.z(), 0.0, along.x()}; }  ///< +Z if along is +X

    double footprint() const { return size.x() * size.z(); }  ///< m²

    /// The distance of an inner point to the nearest face; negative outside.
    double depth_of(const Eigen::Vector3d& point) const;
};

/// Fits an upright box to points.
class UprightBoxFit {
public:
    void add(const Eigen::Vector3d& point);
    bool empty() const { return low_ > high_; }

    /// The box with the smallest footprint if that is 10 % smaller than the axis-aligned box's, else the
    /// axis-aligned box. `along` is within 45 degrees of +X. Sizes may be 0.
    UprightBox box();

    /// Points whose box is the same.
    std::vector<Eigen::Vector3d> vertices();

    /// The area of the plan's convex hull, m².
    double hull_area();

private:
    std::vector<Eigen::Vector2d> plan_;  ///< x, z: the hull so far and the points added since
    std::size_t next_hull_ = 1024;
    double low_ = 1e300;
    double high_ = -1e300;
};

}  // namespace campuswalk::scene
