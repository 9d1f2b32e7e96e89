#include "tests/collision/mesh/loop_queries.h"

#include <algorithm>

#include "collision/geometry/closest.h"
#include "collision/geometry/sweep.h"
#include "collision/geometry/triangle_box_overlap.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {

using support::Dice;

std::vector<std::uint32_t> loop_near(const TriangleMesh& mesh, const Segment& segment, double radius) {
    std::vector<std::uint32_t> near;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (closest(segment, vertices(mesh, t)).distance <= radius) {
            near.push_back(t);
        }
    }
    return near;
}

std::vector<MeshHit> loop_all_on_ray(const TriangleMesh& mesh, const Ray& ray) {
    std::vector<MeshHit> hits;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (const auto f = hit(ray, vertices(mesh, t))) {
            hits.push_back({*f, t});
        }
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const MeshHit& a, const MeshHit& b) { return a.fraction < b.fraction; });
    return hits;
}

std::vector<std::uint32_t> loop_in_box(const TriangleMesh& mesh, const Box& box, const Pose& X_mesh_box) {
    std::vector<std::uint32_t> inside;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle c = vertices(mesh, t);
        const Triangle local{X_mesh_box.inverse_apply(c.a), X_mesh_box.inverse_apply(c.b),
                             X_mesh_box.inverse_apply(c.c)};
        if (overlap(local, box)) {
            inside.push_back(t);
        }
    }
    return inside;
}

MeshPoint loop_closest_point(const TriangleMesh& mesh, const Vec3& point) {
    MeshPoint best;
    best.distance = 1e300;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Closest c = closest(Segment{point, point}, vertices(mesh, t));
        if (c.distance < best.distance) {
            best = {c.on_shape, c.distance, t};
        }
    }
    return best;
}

std::optional<MeshHit> loop_sweep(const TriangleMesh& mesh, const Segment& segment, double radius,
                                  const Vec3& move) {
    std::optional<MeshHit> first;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle triangle = vertices(mesh, t);
        const auto f = first_touch(segment, radius, move,
                                   [&](const Segment& moved) { return closest(moved, triangle); });
        if (f && (!first || *f < first->fraction)) {
            first = MeshHit{*f, t};
        }
    }
    return first;
}

std::vector<SimdTarget> supported_simd_targets() {
    std::vector<SimdTarget> supported;
    for (const SimdTarget i : {SimdTarget::sse42, SimdTarget::avx2, SimdTarget::avx512}) {
        if (can_run(i)) {
            supported.push_back(i);
        }
    }
    return supported;
}

TriangleMesh mesh_of_some_kind(Dice& dice) {
    TriangleMesh mesh;
    switch (dice.below(5)) {
        case 0:
            support::add_floor(mesh, 4.0, 0.0, 0.5);
            support::add_stairs(mesh, 0.0, 0.0, 2.0, 0.17, 0.3, 10);
            return mesh;
        case 1:
            return support::random_mesh(dice, 1, 1.0);
        case 2:
            return support::random_mesh(dice, 80, 0.1);
        default:
            return support::random_mesh(dice, 200, 4.0);
    }
}

TriangleMesh hard_mesh(Dice& dice) {
    switch (dice.below(4)) {
        case 0:
            return support::lattice_soup(dice, 150, Vec3::Zero());
        case 1:
            return support::lattice_soup(dice, 150, Vec3(450000.0, 60.0, -448000.0));
        case 2:
            return support::needles(dice, 120);
        default: {
            TriangleMesh mesh = support::random_mesh(dice, 20, 2.0);
            for (std::array<std::uint32_t, 3>& t : mesh.triangles) {
                t[2] = dice.chance(0.3) ? t[static_cast<std::size_t>(dice.below(2))] : t[2];
            }
            const auto once = mesh.triangles;
            for (int i = 0; i < 6; ++i) {
                mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
            }
            return mesh;
        }
    }
}

Vec3 point_around(const TriangleMesh& mesh, Dice& dice, double reach) {
    const auto t = static_cast<std::size_t>(dice.below(static_cast<int>(mesh.triangles.size())));
    const Triangle c = vertices(mesh, t);
    const double u = dice.between(0.0, 1.0);
    const double v = dice.between(0.0, 1.0 - u);
    return (1.0 - u - v) * c.a + u * c.b + v * c.c + dice.in_cube(reach);
}

}  // namespace campuswalk::collision
