#include "collision/bvh8/bvh8_leaf.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

/// Whether p is exactly a + b, including the sign of zero.
bool is_sum(const Lanes& p, const Lanes& a, const Lanes& b) {
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double sum = static_cast<double>(a[k]) + static_cast<double>(b[k]);
        if (sum != static_cast<double>(p[k]) || std::signbit(sum) != std::signbit(p[k])) {
            return false;
        }
    }
    return true;
}

/// Sets the vertices relative to the centre of their bounds.
void set_vertices(Bvh8Leaf& leaf, std::span<const Lanes> vertices) {
    LaneBounds bounds;
    for (const Lanes& vertex : vertices) {
        bounds.extend(vertex);
    }
    const Lanes origin = bounds.middle();
    double farthest = 0.0;
    leaf.exact = true;
    for (const Lanes& vertex : vertices) {
        const Lanes local = vertex - origin;
        for (std::size_t k = 0; k < 3; ++k) {
            leaf.vertex[k][leaf.vertex_count] = local[static_cast<Eigen::Index>(k)];
        }
        ++leaf.vertex_count;
        leaf.exact = leaf.exact && is_sum(vertex, origin, local);
        farthest = std::max(farthest, exact(local).squaredNorm());
    }
    for (auto& along : leaf.vertex) {
        std::fill(along.begin() + leaf.vertex_count, along.end(), along[leaf.vertex_count - 1U]);
    }
    leaf.origin = {origin[0], origin[1], origin[2], 0.0F};
    leaf.radius = static_cast<float>(std::sqrt(farthest)) * (1.0F + 8.0F * kFloatUnit) + kUnderflow;
}

/// The normal of a triangle, as long as twice its area. Zero where rounding may have rotated it by more than
/// float32's precision: edges and their products are off by a few units of double, relative to their lengths.
Vec3 certain_normal(const Triangle& t) {
    const Vec3 e = t.b - t.a;
    const Vec3 f = t.c - t.a;
    const Vec3 n = e.cross(f);
    constexpr double kMinSine = 0x1p-20;
    const bool certain = n.squaredNorm() > kMinSine * kMinSine * (e.squaredNorm() * f.squaredNorm());
    return certain ? n : Vec3(Vec3::Zero());
}

/// `vertex`: any of the triangle's, relative to the leaf's origin.
void set_plane(Bvh8Leaf& leaf, std::size_t slot, const Vec3& normal, const Vec3& vertex) {
    leaf.plane[3][slot] = 0.0F;
    const double length = normal.norm();
    if (length <= 0.0) {
        return;
    }
    const Eigen::Vector3f unit = (normal * (1.0 / length)).cast<float>();
    for (std::size_t k = 0; k < 3; ++k) {
        leaf.plane[k][slot] = unit[static_cast<Eigen::Index>(k)];
    }
    leaf.plane[3][slot] = static_cast<float>(unit.cast<double>().dot(vertex));
}

/// Returns the sum of the triangles' normals.
Vec3 set_planes(Bvh8Leaf& leaf, std::span<const Lanes> vertices) {
    leaf.plane[3].fill(-1e30F);
    const Vec3 origin = Eigen::Vector3f(leaf.origin[0], leaf.origin[1], leaf.origin[2]).cast<double>();
    Vec3 sum = Vec3::Zero();
    for (std::size_t slot = 0; slot < leaf.triangle_count; ++slot) {
        const Triangle triangle{exact(vertices[leaf.vertex_of[0][slot]]),
                                exact(vertices[leaf.vertex_of[1][slot]]),
                                exact(vertices[leaf.vertex_of[2][slot]])};
        const Vec3 normal = certain_normal(triangle);
        set_plane(leaf, slot, normal, triangle.a - origin);
        sum += normal;
    }
    return sum;
}

void set_facing(Bvh8Leaf& leaf, const Vec3& sum_of_normals) {
    const double length = sum_of_normals.norm();
    const Eigen::Vector3f facing =
        length > 0.0 ? Eigen::Vector3f((sum_of_normals / length).cast<float>()) : Eigen::Vector3f(0, 0, 0);
    leaf.low = std::numeric_limits<float>::max();
    leaf.high = std::numeric_limits<float>::lowest();
    for (std::size_t k = 0; k < 3; ++k) {
        leaf.facing[k] = facing[static_cast<Eigen::Index>(k)];
    }
    for (std::size_t c = 0; c < leaf.vertex_count; ++c) {
        const float along =
            facing[0] * leaf.vertex[0][c] + (facing[1] * leaf.vertex[1][c] + facing[2] * leaf.vertex[2][c]);
        leaf.low = std::min(leaf.low, along);
        leaf.high = std::max(leaf.high, along);
    }
}

}  // namespace

bool LeafMaker::make(std::span<const SplitItem> items, LeafTriangles& leaf) {
    if (items.size() > kLeafTriangles) {
        return false;
    }
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < items.size(); ++slot) {
        const std::uint32_t t = items[slot].triangle();
        const auto& triangle = mesh_.triangles[t];
        leaf.triangle[slot] = t;
        for (std::size_t c = 0; c < 3; ++c) {
            // A slot that doesn't hold the vertex is of an earlier leaf. Every other vertex is new, so this
            // avoids a branch.
            const std::uint32_t vertex = triangle[c];
            const std::size_t last = slot_of_[vertex];
            const bool known = last < count && vertices_[last] == vertex;
            const std::size_t at = known ? last : count;
            vertices_[at] = vertex;
            slot_of_[vertex] = static_cast<std::uint8_t>(at);
            leaf.vertex_of[c][slot] = static_cast<std::uint8_t>(at);
            count += known ? 0 : 1;
        }
    }
    count_ = count;
    leaf.triangle_count = static_cast<std::uint8_t>(items.size());
    leaf.vertex_count = static_cast<std::uint8_t>(count);
    return count <= kLeafVertices;
}

void fill_leaf(Bvh8Leaf& leaf, const LeafTriangles& triangles, std::span<const Lanes> vertices) {
    leaf.triangle = triangles.triangle;
    leaf.vertex_of = triangles.vertex_of;
    leaf.triangle_count = triangles.triangle_count;
    set_vertices(leaf, vertices);
    set_facing(leaf, set_planes(leaf, vertices));
}

}  // namespace campuswalk::collision
