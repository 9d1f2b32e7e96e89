#include "scene/campus/polygon_ears.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

namespace campuswalk::scene {
namespace {

class Polygon {
public:
    Polygon(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal)
        : points_(points), normal_(normal), left_(points.size()) {
        std::iota(left_.begin(), left_.end(), std::size_t{0});
    }

    std::vector<std::array<std::size_t, 3>> cut() {
        std::vector<std::array<std::size_t, 3>> ears;
        while (left_.size() >= 3) {
            std::size_t at = 0;
            while (at < left_.size() && !is_ear(at)) {
                ++at;
            }
            if (at == left_.size()) {
                return {};
            }
            ears.push_back(triangle_at(at));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
        }
        return ears;
    }

private:
    std::array<std::size_t, 3> triangle_at(std::size_t at) const {
        const std::size_t count = left_.size();
        return {left_[(at + count - 1) % count], left_[at], left_[(at + 1) % count]};
    }
    /// Twice the area, positive if the points run counter-clockwise.
    double turn(std::size_t a, std::size_t b, std::size_t c) const {
        return (points_[b] - points_[a]).cross(points_[c] - points_[a]).dot(normal_);
    }
    bool is_ear(std::size_t at) const {
        const std::array<std::size_t, 3> ear = triangle_at(at);
        return left_.size() == 3 ||
               (turn(ear[0], ear[1], ear[2]) >= 0.0 &&
                std::ranges::none_of(left_, [&](std::size_t p) { return is_in(ear, p); }));
    }
    /// Whether the point lies in the ear; a point at the place of one of the ear's own doesn't.
    bool is_in(const std::array<std::size_t, 3>& ear, std::size_t p) const {
        return std::ranges::none_of(ear, [&](std::size_t vertex) { return points_[p] == points_[vertex]; }) &&
               turn(ear[0], ear[1], p) >= 0.0 && turn(ear[1], ear[2], p) >= 0.0 &&
               turn(ear[2], ear[0], p) >= 0.0;
    }

    const std::vector<Eigen::Vector3d>& points_;
    const Eigen::Vector3d& normal_;
    std::vector<std::size_t> left_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> polygon_ears(const std::vector<Eigen::Vector3d>& points,
                                                     const Eigen::Vector3d& normal) {
    return points.size() < 3 ? std::vector<std::array<std::size_t, 3>>() : Polygon(points, normal).cut();
}

}  // namespace campuswalk::scene
