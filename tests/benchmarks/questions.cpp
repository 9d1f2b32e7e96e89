#include "tests/benchmarks/questions.h"

#include <random>

#include "collision/mesh_query.h"

namespace campuswalk::bench {

namespace {

using collision::Ray;
using collision::Segment;
using collision::Vec3;

constexpr double kEyeHeight = 1.6;  ///< metres

/// Uniform in [0, 1): the standard's distributions differ between libraries.
double unit(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967296.0;
}

Vec3 within(const collision::Aabb& box, std::mt19937& random) {
    const Vec3 shares(unit(random), unit(random), unit(random));
    return box.min + shares.cwiseProduct(box.max - box.min);
}

Vec3 direction(std::mt19937& random) {
    while (true) {
        const Vec3 v = 2.0 * Vec3(unit(random), unit(random), unit(random)) - Vec3::Ones();
        if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1.0) {
            return v.normalized();
        }
    }
}

collision::Aabb bounds_of(const collision::TriangleMesh& mesh) {
    collision::Aabb box;
    for (const Eigen::Vector3f& position : mesh.positions) {
        box.extend(position.cast<double>());
    }
    return box;
}

/// Where something dropped from above comes to lie; none beside the campus.
std::optional<Vec3> landing(const collision::MeshCollider& campus, const collision::Aabb& box,
                            std::mt19937& random) {
    Ray down;
    down.from = within(box, random);
    down.from.y() = box.max.y() + 1.0;
    down.to = down.from;
    down.to.y() = box.min.y() - 1.0;
    collision::QueryCounters counters;
    const auto hit = first_on_ray(campus, down, counters);
    return hit ? std::optional(down.at(hit->fraction)) : std::nullopt;
}

}  // namespace

std::vector<Ray> make_rays(const collision::MeshCollider& campus, double length, std::size_t count,
                           std::uint32_t seed) {
    std::mt19937 random(seed);
    const collision::Aabb box = bounds_of(campus.mesh());
    std::vector<Ray> rays;
    while (rays.size() < count) {
        if (const auto ground = landing(campus, box, random)) {
            const Vec3 eye = *ground + Vec3(0, kEyeHeight, 0);
            rays.push_back({eye, eye + length * direction(random)});
        }
    }
    return rays;
}

std::vector<Segment> make_avatars(const collision::MeshCollider& campus, std::size_t count,
                                  std::uint32_t seed) {
    std::mt19937 random(seed);
    const collision::TriangleMesh& mesh = campus.mesh();
    std::vector<Segment> avatars;
    while (avatars.size() < count) {
        const collision::Triangle near = corners(mesh, random() % mesh.triangles.size());
        const Vec3 foot = (near.a + near.b + near.c) / 3.0 + 0.5 * direction(random);
        avatars.push_back(
            {foot + Vec3(0, kAvatarRadius, 0), foot + Vec3(0, kAvatarHeight - kAvatarRadius, 0)});
    }
    return avatars;
}

}  // namespace campuswalk::bench
