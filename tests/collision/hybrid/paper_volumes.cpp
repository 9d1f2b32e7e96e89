#include "tests/collision/hybrid/paper_volumes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

using Real = long double;
using Vec3l = Eigen::Matrix<Real, 3, 1>;
using Mat3l = Eigen::Matrix<Real, 3, 3>;

/// Allowance for rounding, relative to the size of the coordinates.
constexpr Real kSlack = 1e-10L;

std::vector<Vec3l> vertices_in(const TriangleMesh& mesh, Triangles triangles) {
    std::vector<Vec3l> points;
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t v : mesh.triangles[t]) {
            points.push_back(mesh.positions[v].cast<Real>());
        }
    }
    return points;
}

Real size_of(const std::vector<Vec3l>& points) {
    Real size = 1e-3L;
    for (const Vec3l& p : points) {
        size = std::max(size, p.cwiseAbs().maxCoeff());
    }
    return size;
}

Real farthest(const std::vector<Vec3l>& points, const Vec3l& from) {
    Real distance = 0;
    for (const Vec3l& p : points) {
        distance = std::max(distance, (p - from).norm());
    }
    return distance;
}

/// Along the bisector of the angle between the two longest edges, at the inscribed circle's radius over the
/// sine of half that angle.
Vec3l incentre_by_bisector(const Vec3l& a, const Vec3l& b, const Vec3l& c) {
    const Real ab = (b - a).norm();
    const Real ac = (c - a).norm();
    const Real bc = (c - b).norm();
    if (bc > ab || bc > ac) {
        return incentre_by_bisector(b, c, a);
    }
    if (ab == 0) {
        return a;
    }
    const Vec3l bisector = (b - a) / ab + (c - a) / ac;
    return a + ab * ac / (ab + bc + ac) * bisector;
}

::testing::AssertionResult off(const char* what, Real by) {
    return ::testing::AssertionFailure() << what << " off by " << static_cast<double>(by);
}

Mat3l covariance_of(const std::vector<Vec3l>& points) {
    Vec3l mean = Vec3l::Zero();
    for (const Vec3l& p : points) {
        mean += p / static_cast<Real>(points.size());
    }
    Mat3l covariance = Mat3l::Zero();
    for (const Vec3l& p : points) {
        covariance += (p - mean) * (p - mean).transpose() / static_cast<Real>(points.size());
    }
    return covariance;
}

}  // namespace

::testing::AssertionResult is_outer_sphere(const BoundingSphere& sphere, const TriangleMesh& mesh,
                                           Triangles triangles) {
    const std::vector<Vec3l> points = vertices_in(mesh, triangles);
    const Real slack = kSlack * size_of(points);
    Vec3l mean = Vec3l::Zero();
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const Vec3l incentre = incentre_by_bisector(points[i], points[i + 1], points[i + 2]);
        mean += incentre / static_cast<Real>(triangles.size());
    }
    const Vec3l center = sphere.center.cast<Real>();
    if (const Real by = (center - mean).norm(); by > slack) {
        return off("the outer sphere's centre is", by);
    }
    const Real beyond = static_cast<Real>(sphere.radius) - farthest(points, center);
    if (beyond < 0 || beyond > slack) {
        return off("the outer sphere's radius is", beyond);
    }
    return ::testing::AssertionSuccess();
}

::testing::AssertionResult is_inner_box(const OrientedBox& box, const TriangleMesh& mesh,
                                        Triangles triangles) {
    const std::vector<Vec3l> points = vertices_in(mesh, triangles);
    const Real slack = kSlack * size_of(points);
    const Mat3l axes = box.axes.cast<Real>();
    if (const Real by = (axes.transpose() * axes - Mat3l::Identity()).norm(); by > kSlack) {
        return off("orthonormal axes are", by);
    }
    const Mat3l covariance = covariance_of(points);
    const Vec3l center = box.center.cast<Real>();
    for (int i = 0; i < 3; ++i) {
        const Vec3l axis = axes.col(i);
        const Vec3l image = covariance * axis;
        const Real by = (image - image.dot(axis) * axis).norm();
        if (by > kSlack * (covariance.trace() + slack * slack)) {
            return off("an eigenvector is", by);
        }
        Real low = 1e300L;
        Real high = -1e300L;
        for (const Vec3l& p : points) {
            low = std::min(low, (p - center).dot(axis));
            high = std::max(high, (p - center).dot(axis));
        }
        const auto half = static_cast<Real>(box.half_extents[i]);
        if (half < high || half < -low || half > high + slack || half > -low + slack) {
            return off("an extent is", std::max(half - high, half + low));
        }
    }
    const Real beyond = static_cast<Real>(box.radius) - farthest(points, center);
    if (beyond < 0 || beyond > slack) {
        return off("the inner sphere's radius is", beyond);
    }
    return ::testing::AssertionSuccess();
}

}  // namespace campuswalk::collision
