#pragma once

#include <array>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace campuswalk::engine::render {

/// View frustum of a clip matrix, for culling.
class Frustum {
public:
    explicit Frustum(const Eigen::Matrix4d& clip_frame) {
        const auto row = [&](int i) -> Eigen::Vector4d { return clip_frame.row(i).transpose(); };
        planes_ = {row(3) + row(0), row(3) - row(0), row(3) + row(1),
                   row(3) - row(1), row(2),          row(3) - row(2)};
    }

    /// Conservative: false only if the box (in the matrix's source frame) is entirely outside.
    bool may_intersect(const Eigen::AlignedBox3d& box) const {
        for (const Eigen::Vector4d& plane : planes_) {
            const Eigen::Vector3d furthest = (plane.head<3>().array() > 0.0).select(box.max(), box.min());
            if (plane.head<3>().dot(furthest) + plane.w() < 0.0) {
                return false;
            }
        }
        return true;
    }

private:
    std::array<Eigen::Vector4d, 6> planes_;  // inside is positive
};

}  // namespace campuswalk::engine::render
