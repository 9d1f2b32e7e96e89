#include "tests/support/contact_scenes.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "collision/geometry/triangle_overlap.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::support {

using collision::Mat3;
using collision::Pose;
using collision::Triangle;
using collision::TriangleMesh;
using collision::TrianglePair;
using collision::Vec3;

std::vector<TrianglePair> loop_contacts(const TriangleMesh& a, const TriangleMesh& b, const Pose& X_a_b) {
    std::vector<Triangle> moved;
    for (const auto& v : b.triangles) {
        moved.push_back({b_vertex_in_a(X_a_b, b.positions[v[0]]), b_vertex_in_a(X_a_b, b.positions[v[1]]),
                         b_vertex_in_a(X_a_b, b.positions[v[2]])});
    }
    std::vector<TrianglePair> pairs;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        const Triangle first = vertices(a, i);
        for (std::uint32_t j = 0; j < moved.size(); ++j) {
            if (overlap(first, moved[j])) {
                pairs.push_back({i, j});
            }
        }
    }
    return pairs;
}

TriangleMesh lattice_soup(Dice& dice, int triangles, const Vec3& at) {
    const auto vertex = [&] {
        const double x = dice.below(7);
        const double y = dice.below(7);
        return Vec3(at + Vec3(x, y, dice.below(7)));
    };
    TriangleMesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const Vec3 p = vertex();
        const Vec3 q = vertex();
        add_triangle(mesh, p, q, dice.chance(0.1) ? q : vertex());
    }
    return mesh;
}

Mat3 lattice_turn(Dice& dice) {
    Mat3 turn = Mat3::Zero();
    const int first = dice.below(3);
    const int second = (first + 1 + dice.below(2)) % 3;
    turn(0, first) = dice.chance(0.5) ? 1.0 : -1.0;
    turn(1, second) = dice.chance(0.5) ? 1.0 : -1.0;
    turn.row(2) = turn.row(0).cross(turn.row(1));
    return turn;
}

TriangleMesh ball(int n) {
    TriangleMesh mesh;
    const auto add = [&](int i, int j) {
        const double up = std::numbers::pi * i / n;
        const double around = 2.0 * std::numbers::pi * j / n;
        mesh.positions.push_back(
            Vec3(std::sin(up) * std::cos(around), std::cos(up), std::sin(up) * std::sin(around))
                .cast<float>());
    };
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(1 + (i - 1) * n + j % n); };
    add(0, 0);
    for (int i = 1; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            add(i, j);
        }
    }
    add(n, 0);
    const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    for (int j = 0; j < n; ++j) {
        mesh.triangles.push_back({0U, at(1, j), at(1, j + 1)});
        for (int i = 1; i + 1 < n; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
        mesh.triangles.push_back({at(n - 1, j), last, at(n - 1, j + 1)});
    }
    return mesh;
}

TriangleMesh needles(Dice& dice, int count) {
    TriangleMesh mesh;
    const Vec3 common = dice.in_cube(1.0).normalized();
    for (int i = 0; i < count; ++i) {
        const Vec3 direction = dice.chance(0.5) ? common : Vec3(dice.in_cube(1.0));
        const Vec3 along = std::pow(10.0, dice.between(0.0, 4.0)) * direction;
        const Vec3 at = dice.in_cube(1.0) - dice.between(0.0, 1.0) * along;
        const double width = dice.chance(0.3) ? 0.0 : std::pow(10.0, dice.between(-7.0, -1.0));
        add_triangle(mesh, at, at + along, at + dice.in_cube(width));
    }
    return mesh;
}

}  // namespace campuswalk::support
