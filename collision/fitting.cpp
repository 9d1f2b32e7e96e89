#include "collision/fitting.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace campuswalk::collision {

namespace {

template <typename Visit>
void for_each_corner(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, Visit visit) {
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t v : mesh.triangles[t]) {
            visit(Vec3(mesh.positions[v].cast<double>()));
        }
    }
}

double farthest(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, const Vec3& from) {
    double squared = 0.0;
    for_each_corner(mesh, triangles,
                    [&](const Vec3& p) { squared = std::max(squared, (p - from).squaredNorm()); });
    const double radius = std::sqrt(squared);
    return radius + kOutward * (radius + from.cwiseAbs().maxCoeff());
}

}  // namespace

Vec3 incentre(const Triangle& t) {
    const double a = (t.b - t.c).norm();
    const double b = (t.c - t.a).norm();
    const double c = (t.a - t.b).norm();
    const double perimeter = a + b + c;
    if (perimeter <= 0.0) {
        return t.a;
    }
    return (a * t.a + b * t.b + c * t.c) / perimeter;
}

BoundingSphere fit_outer_sphere(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t t : triangles) {
        sum += incentre(corners(mesh, t));
    }
    const Vec3 center = sum / static_cast<double>(triangles.size());
    return {center, farthest(mesh, triangles, center)};
}

OrientedBox fit_inner_box(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
    const double count = 3.0 * static_cast<double>(triangles.size());
    Vec3 mean = Vec3::Zero();
    for_each_corner(mesh, triangles, [&](const Vec3& p) { mean += p; });
    mean /= count;

    Mat3 covariance = Mat3::Zero();
    for_each_corner(mesh, triangles, [&](const Vec3& p) {
        const Vec3 d = p - mean;
        covariance += d * d.transpose();
    });
    covariance /= count;

    OrientedBox box;
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance);
    if (eigen.info() == Eigen::Success) {
        box.axes = eigen.eigenvectors();
    }

    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);
    for_each_corner(mesh, triangles, [&](const Vec3& p) {
        const Vec3 along = box.axes.transpose() * (p - mean);
        low = low.cwiseMin(along);
        high = high.cwiseMax(along);
    });
    box.center = mean + box.axes * (0.5 * (low + high));
    const double slack = kOutward * (box.center.cwiseAbs().maxCoeff() + (high - low).maxCoeff());
    box.half_extents = (0.5 * (high - low)).array() + slack;
    box.radius = farthest(mesh, triangles, box.center);
    return box;
}

}  // namespace campuswalk::collision
