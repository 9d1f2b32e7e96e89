#include "collision/geometry/fitting.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace campuswalk::collision {

namespace {

template <typename Visit>
void for_each_vertex(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, Visit visit) {
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t v : mesh.triangles[t]) {
            visit(Vec3(mesh.positions[v].cast<double>()));
        }
    }
}

BoundingSphere sphere_to_farthest(const Vec3& center, const TriangleMesh& mesh,
                                  std::span<const std::uint32_t> triangles) {
    double squared = 0.0;
    for_each_vertex(mesh, triangles,
                    [&](const Vec3& p) { squared = std::max(squared, (p - center).squaredNorm()); });
    return sphere_about(center, squared);
}

}  // namespace

BoundingSphere sphere_about(const Vec3& center, double squared) {
    const double radius = std::sqrt(squared);
    return {center, radius + kOutward * (radius + center.cwiseAbs().maxCoeff())};
}

BoundingSphere fit_outer_sphere(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t t : triangles) {
        sum += incentre(vertices(mesh, t));
    }
    return sphere_to_farthest(sum / static_cast<double>(triangles.size()), mesh, triangles);
}

OrientedBox fit_inner_box(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
    const double count = 3.0 * static_cast<double>(triangles.size());
    Vec3 mean = Vec3::Zero();
    for_each_vertex(mesh, triangles, [&](const Vec3& p) { mean += p; });
    mean /= count;

    Mat3 covariance = Mat3::Zero();
    for_each_vertex(mesh, triangles, [&](const Vec3& p) {
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
    for_each_vertex(mesh, triangles, [&](const Vec3& p) {
        const Vec3 along = box.axes.transpose() * (p - mean);
        low = low.cwiseMin(along);
        high = high.cwiseMax(along);
    });
    box.center = mean + box.axes * (0.5 * (low + high));
    const double slack = kOutward * (box.center.cwiseAbs().maxCoeff() + (high - low).maxCoeff());
    box.half_extents = (0.5 * (high - low)).array() + slack;
    box.radius = sphere_to_farthest(box.center, mesh, triangles).radius;
    return box;
}

}  // namespace campuswalk::collision
