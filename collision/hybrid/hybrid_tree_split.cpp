#include "collision/hybrid/hybrid_tree_split.h"

#include <algorithm>
#include <array>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

namespace {

/// Cuts are tried between this many slices of an axis. Half as many cost 5 % more node tests, teapot against
/// cylinder; twice as many save nothing.
constexpr std::size_t kSlices = 16;

/// A triangle's bounds along the axes of the box.
Aabb bounds_along(const OrientedBox& box, const Triangle& t) {
    Aabb bounds;
    for (const Vec3* vertex : {&t.a, &t.b, &t.c}) {
        bounds.extend(box.axes.transpose() * (*vertex - box.center));
    }
    return bounds;
}

struct Slice {
    Aabb bounds;
    std::size_t triangles = 0;

    void add(const Slice& o) {
        bounds.extend(o.bounds);
        triangles += o.triangles;
    }
    /// Triangles times half the surface area.
    double cost() const {
        if (triangles == 0) {
            return 0.0;
        }
        const Vec3 d = bounds.max - bounds.min;
        return static_cast<double>(triangles) * (d.x() * d.y() + d.y() * d.z() + d.z() * d.x());
    }
};

/// The slice of an axis that a triangle falls into, by the centre of its bounds.
std::size_t slice_of(const OrientedBox& box, const Aabb& bounds, int axis) {
    const double half = box.half_extents[axis];
    const double middle = 0.5 * (bounds.min[axis] + bounds.max[axis]);
    const double at = half > 0.0 ? (middle + half) / (2.0 * half) * static_cast<double>(kSlices) : 0.0;
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(kSlices - 1)));
}

struct Cut {
    int axis = 0;
    std::size_t slice = 0;  ///< the first slice of the right side; 0: no cut
    double cost = 0.0;
};

using Slices = std::array<Slice, kSlices>;

/// Replaces `best` by a cheaper cut across `axis` that leaves at least `least` triangles on both sides.
void improve(Cut& best, const Slices& slices, int axis, std::size_t least) {
    Slices right = slices;  // each merged with all that come after it
    for (std::size_t k = kSlices - 1; k-- > 0;) {
        right[k].add(right[k + 1]);
    }
    Slice left;
    for (std::size_t k = 1; k < kSlices; ++k) {
        left.add(slices[k - 1]);
        const double cost = left.cost() + right[k].cost();
        if (cost < best.cost && left.triangles >= least && right[k].triangles >= least) {
            best = {axis, k, cost};
        }
    }
}

Cut cheapest_cut(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, const OrientedBox& box) {
    Slice all;
    std::array<Slices, 3> slices;
    for (const std::uint32_t t : triangles) {
        const Slice one{bounds_along(box, vertices(mesh, t)), 1};
        all.add(one);
        for (int axis = 0; axis < 3; ++axis) {
            slices[static_cast<std::size_t>(axis)][slice_of(box, one.bounds, axis)].add(one);
        }
    }
    const std::size_t least = std::max<std::size_t>(1, triangles.size() / kMinSideDivisor);
    Cut best{0, 0, all.cost()};
    for (int axis = 0; axis < 3; ++axis) {
        improve(best, slices[static_cast<std::size_t>(axis)], axis, least);
    }
    return best;
}

std::size_t halve(const TriangleMesh& mesh, std::span<std::uint32_t> triangles, const OrientedBox& box) {
    int longest = 0;
    box.half_extents.maxCoeff(&longest);
    const auto at = [&](std::uint32_t t) {
        const Aabb bounds = bounds_along(box, vertices(mesh, t));
        return bounds.min[longest] + bounds.max[longest];
    };
    const std::size_t half = triangles.size() / 2;
    std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half),
                     triangles.end(), [&](std::uint32_t s, std::uint32_t t) {
                         const double x = at(s);
                         const double y = at(t);
                         return x != y ? x < y : s < t;
                     });
    return half;
}

}  // namespace

std::size_t split(const TriangleMesh& mesh, std::span<std::uint32_t> triangles, const OrientedBox& box) {
    const Cut cut = cheapest_cut(mesh, triangles, box);
    if (cut.slice == 0) {
        return halve(mesh, triangles, box);
    }
    const auto middle = std::stable_partition(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
        return slice_of(box, bounds_along(box, vertices(mesh, t)), cut.axis) < cut.slice;
    });
    return static_cast<std::size_t>(middle - triangles.begin());
}

}  // namespace campuswalk::collision
