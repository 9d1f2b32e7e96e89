#include "collision/bvh8/bvh8_fit.h"

#include <algorithm>
#include <array>

#include "collision/geometry/principal_axes.h"

namespace campuswalk::collision {

namespace {

/// The boxes of a node's children, and their bounds.
struct Boxes {
    std::array<LaneBounds, kBvh8Children> of;
    LaneBounds all;
    float area = 0.0F;

    void set(std::size_t child, const LaneBounds& box) {
        of[child] = box;
        all.extend(box);
        area += box.half_area();
    }
};

/// Along the mesh's axes, about `origin`.
Boxes straight_boxes(std::span<const Contents> children, const Lanes& origin) {
    Boxes boxes;
    for (std::size_t c = 0; c < children.size(); ++c) {
        boxes.set(c, {children[c].bounds.min - origin, children[c].bounds.max - origin});
    }
    return boxes;
}

Boxes rotated_boxes(std::span<const Contents> children, const Lanes& origin, const Eigen::Matrix3f& axes) {
    const Lanes x = lanes(axes.col(0));
    const Lanes y = lanes(axes.col(1));
    const Lanes z = lanes(axes.col(2));
    Boxes boxes;
    for (std::size_t c = 0; c < children.size(); ++c) {
        LaneBounds box;
        for (const Lanes& vertex : children[c].vertices) {
            const Lanes d = vertex - origin;
            box.extend(Lanes(x * d[0] + (y * d[1] + z * d[2])));
        }
        boxes.set(c, box);
    }
    return boxes;
}

/// A vertex's coordinate in the frame is a sum of three products of rounded differences: it is off by at most
/// 5 kFloatUnit times its distance from the origin, which is itself off by at most 10 of them. Halving and
/// adding the ends adds 3 more, so 16 cover all.
void set_boxes(Bvh8Node& node, const Boxes& boxes, std::size_t count) {
    const Lanes reach = boxes.all.min.abs().max(boxes.all.max.abs());
    const auto length = static_cast<float>(reach.head<3>().matrix().cast<double>().norm());
    const float outward = 16.0F * kFloatUnit * length + kUnderflow;
    for (std::size_t c = 0; c < count; ++c) {
        const Lanes low = 0.5F * boxes.of[c].min;
        const Lanes high = 0.5F * boxes.of[c].max;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            node.center[k][c] = high[axis] + low[axis];
            node.half[k][c] = (high[axis] - low[axis]) + outward;
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        node.low[k] = std::numeric_limits<float>::max();
        node.high[k] = std::numeric_limits<float>::lowest();
        for (std::size_t c = 0; c < count; ++c) {
            node.low[k] = std::min(node.low[k], node.center[k][c] - node.half[k][c]);
            node.high[k] = std::max(node.high[k], node.center[k][c] + node.half[k][c]);
        }
    }
    node.radius = length + 4.0F * outward;
}

}  // namespace

void PointMoments::add(const Vec3& point) {
    const Eigen::Array3d p = point.array();
    count += 1.0;
    sum += p;
    squares += p * p;
    mixed += p * Eigen::Array3d(p[1], p[2], p[0]);
}

void PointMoments::add(const PointMoments& o) {
    count += o.count;
    sum += o.sum;
    squares += o.squares;
    mixed += o.mixed;
}

Mat3 PointMoments::covariance() const {
    const Eigen::Array3d mean = sum / count;
    const Eigen::Array3d variance = squares / count - mean * mean;
    Mat3 covariance = variance.matrix().asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        covariance(i, j) = covariance(j, i) = mixed[i] / count - mean[i] * mean[j];
    }
    return covariance;
}

Contents contents_of(std::span<const Lanes> vertices, const Vec3& origin) {
    Contents contents;
    contents.vertices = vertices;
    for (const Lanes& vertex : vertices) {
        contents.bounds.extend(vertex);
        contents.moments.add(exact(vertex) - origin);
    }
    return contents;
}

Contents contents_of(std::span<const Contents> children) {
    Contents all;
    const Lanes* first = children.front().vertices.data();
    std::size_t count = 0;
    for (const Contents& child : children) {
        first = std::min(first, child.vertices.data());
        count += child.vertices.size();
        all.bounds.extend(child.bounds);
        all.moments.add(child.moments);
    }
    all.vertices = {first, count};
    return all;
}

BoundingSphere sphere_about(const Vec3& center, std::span<const Lanes> vertices) {
    double squared = 0.0;
    for (const Lanes& vertex : vertices) {
        squared = std::max(squared, (exact(vertex) - center).squaredNorm());
    }
    return sphere_about(center, squared);
}

void fit_node(Bvh8Node& node, std::span<const Contents> children, const Contents& all) {
    const Lanes origin = all.bounds.middle();
    // A rotated frame must outweigh the work of rotating rays and capsules into it.
    constexpr float kWorthRotating = 0.9F;
    Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
    Boxes boxes = straight_boxes(children, origin);
    const Eigen::Matrix3f rotated = principal_axes(all.moments.covariance()).transpose().cast<float>();
    if (const Boxes other = rotated_boxes(children, origin, rotated);
        other.area < kWorthRotating * boxes.area) {
        axes = rotated;
        boxes = other;
        node.rotated = true;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        node.origin[k] = origin[static_cast<Eigen::Index>(k)];
        for (std::size_t j = 0; j < 3; ++j) {
            node.axes[k][j] = axes(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
        }
    }
    set_boxes(node, boxes, children.size());
}

}  // namespace campuswalk::collision
