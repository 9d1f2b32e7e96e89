#include "scene/model/upright_box.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

struct Rectangle {
    Vector2d along = Vector2d::UnitX();
    Vector2d low = Vector2d::Constant(1e300);  // along, across
    Vector2d high = Vector2d::Constant(-1e300);

    double area() const { return (high - low).prod(); }
};

Rectangle rectangle_about(const std::vector<Vector2d>& points, const Vector2d& along) {
    Rectangle rectangle;
    rectangle.along = along;
    const Vector2d across(-along.y(), along.x());
    for (const Vector2d& p : points) {
        const Vector2d local(p.dot(along), p.dot(across));
        rectangle.low = rectangle.low.cwiseMin(local);
        rectangle.high = rectangle.high.cwiseMax(local);
    }
    return rectangle;
}

/// Rotates by multiples of 90 degrees to within 45 degrees of +X.
Vector2d nearest_to_x(Vector2d along) {
    if (std::abs(along.y()) > std::abs(along.x())) {
        along = Vector2d(along.y(), -along.x());
    }
    return along.x() < 0.0 ? Vector2d(-along) : along;
}

/// Counter-clockwise for x to the right and y up, without points on its edges. Andrew's monotone chain.
std::vector<Vector2d> convex_hull(std::vector<Vector2d> points) {
    std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        return points;
    }
    std::vector<Vector2d> hull;  // lower chain, then upper
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Vector2d& p : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();  // it starts the other chain
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

double UprightBox::depth_of(const Vector3d& point) const {
    const Vector3d from = point - center;
    const Vector3d local(from.dot(along), from.y(), from.dot(across()));
    return (0.5 * size - local.cwiseAbs()).minCoeff();
}

void UprightBoxFit::add(const Vector3d& point) {
    low_ = std::min(low_, point.y());
    high_ = std::max(high_, point.y());
    plan_.emplace_back(point.x(), point.z());
    if (plan_.size() >= next_hull_) {
        plan_ = convex_hull(std::move(plan_));
        next_hull_ = std::max<std::size_t>(1024, 2 * plan_.size());
    }
}

std::vector<Vector3d> UprightBoxFit::vertices() {
    plan_ = convex_hull(std::move(plan_));
    std::vector<Vector3d> points;
    for (const Vector2d& p : plan_) {
        points.emplace_back(p.x(), low_, p.y());
        points.emplace_back(p.x(), high_, p.y());
    }
    return points;
}

double UprightBoxFit::hull_area() {
    plan_ = convex_hull(std::move(plan_));
    double twice = 0.0;
    for (std::size_t i = 2; i < plan_.size(); ++i) {
        twice += cross(plan_[i - 1] - plan_[0], plan_[i] - plan_[0]);
    }
    return 0.5 * twice;
}

UprightBox UprightBoxFit::box() {
    plan_ = convex_hull(std::move(plan_));
    const Rectangle level = rectangle_about(plan_, Vector2d::UnitX());
    Rectangle best = level;
    for (std::size_t i = 0; i < plan_.size();
         ++i) {  // a side of the smallest rectangle is collinear with a hull edge
        const Vector2d edge = plan_[(i + 1) % plan_.size()] - plan_[i];
        if (edge.squaredNorm() > 0.0) {
            const Rectangle turned = rectangle_about(plan_, nearest_to_x(edge.normalized()));
            best = turned.area() < best.area() ? turned : best;
        }
    }
    if (best.area() > 0.9 * level.area()) {
        best = level;
    }
    const Vector2d middle = 0.5 * (best.low + best.high);
    const Vector2d across(-best.along.y(), best.along.x());
    const Vector2d centre = middle.x() * best.along + middle.y() * across;
    const Vector2d size = best.high - best.low;
    UprightBox box;
    box.center = {centre.x(), 0.5 * (low_ + high_), centre.y()};
    box.size = {size.x(), high_ - low_, size.y()};
    box.along = {best.along.x(), 0.0, best.along.y()};
    return box;
}

}  // namespace campuswalk::scene
