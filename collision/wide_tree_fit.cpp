#include "collision/wide_tree_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

using Children = std::span<const std::span<const SplitItem>>;

/// Added to every bound: a product that underflows is off by less, whatever the scale.
constexpr float kUnderflow = std::numeric_limits<float>::min();

Lanes lanes(const Eigen::Vector3f& p) {
    return {p.x(), p.y(), p.z(), 0.0F};
}

Lanes middle(const LaneBounds& bounds) {
    return 0.5F * bounds.min + 0.5F * bounds.max;
}

template <typename Visit>
void for_each_corner(const TriangleMesh& mesh, std::span<const SplitItem> items, Visit visit) {
    for (const SplitItem& item : items) {
        for (const std::uint32_t v : mesh.triangles[item.triangle]) {
            visit(mesh.positions[v]);
        }
    }
}

/// Rows: the eigenvectors of the corners' covariance. Exact sums don't matter, any rotation will do.
Eigen::Matrix3f principal_axes(const TriangleMesh& mesh, Children children, const Lanes& about) {
    Lanes sum = Lanes::Zero();
    Lanes squares = Lanes::Zero();
    Lanes mixed = Lanes::Zero();
    float count = 0.0F;
    for (const std::span<const SplitItem> items : children) {
        for_each_corner(mesh, items, [&](const Eigen::Vector3f& p) {
            const Lanes d = lanes(p) - about;
            sum += d;
            squares += d * d;
            mixed += d * Lanes(d[1], d[2], d[0], 0.0F);
        });
        count += 3.0F * static_cast<float>(items.size());
    }
    const Eigen::Array3d mean = sum.head<3>().cast<double>() / count;
    const Eigen::Array3d variance = squares.head<3>().cast<double>() / count - mean * mean;
    const Eigen::Array3d mixture = mixed.head<3>().cast<double>() / count;
    Mat3 covariance = variance.matrix().asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        covariance(i, j) = covariance(j, i) = mixture[i] - mean[i] * mean[j];
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance);
    if (eigen.info() != Eigen::Success || !eigen.eigenvectors().allFinite()) {
        return Eigen::Matrix3f::Identity();
    }
    return eigen.eigenvectors().transpose().cast<float>();
}

/// The boxes of a node's children, and what all of them hold.
struct Boxes {
    std::array<LaneBounds, kWideChildren> of;
    LaneBounds all;
    float area = 0.0F;

    void set(std::size_t child, const LaneBounds& box) {
        of[child] = box;
        all.extend(box);
        area += box.half_area();
    }
};

/// Along the mesh's axes, about `origin`: what holds the triangles' bounds holds their corners.
Boxes straight_boxes(std::span<const LaneBounds> bounds, const Lanes& origin) {
    Boxes boxes;
    for (std::size_t c = 0; c < bounds.size(); ++c) {
        boxes.set(c, {bounds[c].min - origin, bounds[c].max - origin});
    }
    return boxes;
}

Boxes turned_boxes(const TriangleMesh& mesh, Children children, const Lanes& origin,
                   const Eigen::Matrix3f& axes) {
    const Lanes x = lanes(axes.col(0));
    const Lanes y = lanes(axes.col(1));
    const Lanes z = lanes(axes.col(2));
    Boxes boxes;
    for (std::size_t c = 0; c < children.size(); ++c) {
        LaneBounds box;
        for_each_corner(mesh, children[c], [&](const Eigen::Vector3f& p) {
            const Lanes d = lanes(p) - origin;
            box.extend(Lanes(x * d[0] + (y * d[1] + z * d[2])));
        });
        boxes.set(c, box);
    }
    return boxes;
}

/// A corner's place in the frame is a sum of three products of rounded differences: it is off by at most
/// 5 kFloatUnit times its distance from the origin, which is itself known to within 10 of them. Halving and
/// adding the ends adds 3 more, so 16 hold all.
void set_boxes(WideNode& node, const Boxes& boxes, std::size_t count) {
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

/// The normal of a triangle, as long as its double area. Zero where rounding may have turned it by more than
/// float32 shows: edges and their products are off by a few units of double, relative to their lengths.
Vec3 certain_normal(const Triangle& t) {
    const Vec3 e = t.b - t.a;
    const Vec3 f = t.c - t.a;
    const Vec3 n = e.cross(f);
    constexpr double kLeastSine = 0x1p-20;
    return n.norm() > kLeastSine * e.norm() * f.norm() ? n : Vec3(Vec3::Zero());
}

/// `corner`: any of the triangle's, less the leaf's origin.
void set_plane(WideLeaf& leaf, std::size_t slot, const Vec3& normal, const Vec3& corner) {
    leaf.plane[3][slot] = 0.0F;
    const double length = normal.norm();
    if (length <= 0.0) {
        return;
    }
    const Eigen::Vector3f unit = (normal / length).cast<float>();
    for (std::size_t k = 0; k < 3; ++k) {
        leaf.plane[k][slot] = unit[static_cast<Eigen::Index>(k)];
    }
    leaf.plane[3][slot] = static_cast<float>(unit.cast<double>().dot(corner));
}

void set_facing(WideLeaf& leaf, const Vec3& sum_of_normals) {
    const double length = sum_of_normals.norm();
    const Eigen::Vector3f facing =
        length > 0.0 ? Eigen::Vector3f((sum_of_normals / length).cast<float>()) : Eigen::Vector3f(0, 0, 0);
    leaf.low = std::numeric_limits<float>::max();
    leaf.high = std::numeric_limits<float>::lowest();
    for (std::size_t k = 0; k < 3; ++k) {
        leaf.facing[k] = facing[static_cast<Eigen::Index>(k)];
    }
    for (std::size_t c = 0; c < leaf.corners; ++c) {
        const float along =
            facing[0] * leaf.corner[0][c] + (facing[1] * leaf.corner[1][c] + facing[2] * leaf.corner[2][c]);
        leaf.low = std::min(leaf.low, along);
        leaf.high = std::max(leaf.high, along);
    }
}

/// Whether p is a + b to the last bit, the sign of zero among them.
bool is_sum(const Eigen::Vector3f& p, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double sum = static_cast<double>(a[k]) + static_cast<double>(b[k]);
        if (sum != static_cast<double>(p[k]) || std::signbit(sum) != std::signbit(p[k])) {
            return false;
        }
    }
    return true;
}

/// The corners of a leaf, each once.
class CornerList {
public:
    /// Where a vertex is in the list; at its end if it is new.
    std::size_t place(std::uint32_t vertex) {
        const auto end = seen_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto found = std::find(seen_.begin(), end, vertex);
        if (found == end) {
            seen_[count_++] = vertex;
        }
        return static_cast<std::size_t>(found - seen_.begin());
    }
    std::size_t size() const { return count_; }

private:
    std::array<std::uint32_t, 3 * kLeafTriangles> seen_{};
    std::size_t count_ = 0;
};

}  // namespace

void fit_node(WideNode& node, const TriangleMesh& mesh, Children children) {
    std::array<LaneBounds, kWideChildren> bounds;
    LaneBounds all;
    for (std::size_t c = 0; c < children.size(); ++c) {
        for (const SplitItem& item : children[c]) {
            bounds[c].extend(item.bounds);
        }
        all.extend(bounds[c]);
    }
    const Lanes origin = middle(all);
    // A turned frame must pay for the work of turning rays and capsules into it.
    constexpr float kWorthTurning = 0.9F;
    Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
    Boxes boxes = straight_boxes({bounds.data(), children.size()}, origin);
    const Eigen::Matrix3f turned = principal_axes(mesh, children, origin);
    if (const Boxes other = turned_boxes(mesh, children, origin, turned);
        other.area < kWorthTurning * boxes.area) {
        axes = turned;
        boxes = other;
        node.turned = true;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        node.origin[k] = origin[static_cast<Eigen::Index>(k)];
        for (std::size_t j = 0; j < 3; ++j) {
            node.axes[k][j] = axes(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
        }
    }
    node.count = static_cast<std::uint8_t>(children.size());
    set_boxes(node, boxes, children.size());
}

bool fits_leaf(const TriangleMesh& mesh, std::span<const SplitItem> items) {
    if (items.size() > kLeafTriangles) {
        return false;
    }
    CornerList corners;
    for (const SplitItem& item : items) {
        for (const std::uint32_t v : mesh.triangles[item.triangle]) {
            corners.place(v);
        }
    }
    return corners.size() <= kLeafCorners;
}

WideLeaf make_leaf(const TriangleMesh& mesh, std::span<const SplitItem> items) {
    WideLeaf leaf;
    LaneBounds bounds;
    for (const SplitItem& item : items) {
        leaf.triangle[leaf.triangles++] = item.triangle;
        bounds.extend(item.bounds);
    }
    std::sort(leaf.triangle.begin(), leaf.triangle.begin() + leaf.triangles);
    const Eigen::Vector3f origin = middle(bounds).head<3>();
    leaf.origin = {origin.x(), origin.y(), origin.z(), 0.0F};
    leaf.plane[3].fill(-1e30F);

    CornerList list;
    leaf.exact = true;
    Vec3 sum_of_normals = Vec3::Zero();
    for (std::size_t slot = 0; slot < leaf.triangles; ++slot) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = mesh.triangles[leaf.triangle[slot]][c];
            const std::size_t at = list.place(v);
            leaf.corner_of[c][slot] = static_cast<std::uint8_t>(at);
            const Eigen::Vector3f local = mesh.positions[v] - origin;
            for (std::size_t k = 0; k < 3; ++k) {
                leaf.corner[k][at] = local[static_cast<Eigen::Index>(k)];
            }
            leaf.exact = leaf.exact && is_sum(mesh.positions[v], origin, local);
            const auto length = static_cast<float>(local.cast<double>().norm());
            leaf.radius = std::max(leaf.radius, length * (1.0F + 8.0F * kFloatUnit) + kUnderflow);
        }
        const Triangle triangle = corners(mesh, leaf.triangle[slot]);
        const Vec3 normal = certain_normal(triangle);
        set_plane(leaf, slot, normal, triangle.a - origin.cast<double>());
        sum_of_normals += normal;
    }
    leaf.corners = static_cast<std::uint8_t>(list.size());
    for (auto& along : leaf.corner) {
        std::fill(along.begin() + leaf.corners, along.end(), along[leaf.corners - 1U]);
    }
    set_facing(leaf, sum_of_normals);
    return leaf;
}

}  // namespace campuswalk::collision
