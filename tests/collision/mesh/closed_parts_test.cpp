#include "collision/mesh/closed_parts.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "tests/collision/mesh/solid_angle.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/solid_mesh.h"

namespace campuswalk::collision {
namespace {

using support::add_box;
using support::add_quad;

TriangleMesh flipped(TriangleMesh mesh) {
    for (auto& t : mesh.triangles) {
        std::swap(t[0], t[1]);
    }
    return mesh;
}

TriangleMesh unit_box() {
    TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {1, 1, 1});
    return mesh;
}

void append(TriangleMesh& to, const TriangleMesh& more) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
    for (const auto& t : more.triangles) {
        to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
}

/// A ring with a bumpy tube, facing outward: neither convex nor simply connected.
TriangleMesh ring() {
    constexpr int kAround = 24;
    constexpr int kTube = 12;
    const auto at = [](int i, int j) {
        const double u = 2.0 * std::numbers::pi * (i % kAround) / kAround;
        const double v = 2.0 * std::numbers::pi * (j % kTube) / kTube;
        const double radius = 3.0 + (0.8 + 0.2 * std::cos(3 * u)) * std::cos(v);
        return Vec3(radius * std::cos(u), std::sin(v), radius * std::sin(u));
    };
    TriangleMesh mesh;
    for (int i = 0; i < kAround; ++i) {
        for (int j = 0; j < kTube; ++j) {
            add_quad(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        }
    }
    return mesh;
}

void expect_agreement_with_solid_angles(const TriangleMesh& mesh, double reach, std::uint32_t seed) {
    const support::SolidMesh parts(mesh);
    support::Dice dice(seed);
    int inside = 0;
    for (int i = 0; i < support::repeats(3000); ++i) {
        const Vec3 p = dice.in_cube(reach);
        const double winding = winding_number(mesh, p);
        ASSERT_EQ(parts.contains(p), winding > 0.5) << p.transpose() << " winding " << winding;
        inside += winding > 0.5 ? 1 : 0;
    }
    EXPECT_GT(inside, support::repeats(3000) / 60);
}

TEST(ClosedParts, OfABoxContainItsInterior) {
    EXPECT_FALSE(ClosedParts(unit_box()).empty());
    const support::SolidMesh parts(unit_box());
    EXPECT_TRUE(parts.contains({0.5, 0.5, 0.5}));
    EXPECT_TRUE(parts.contains({0.01, 0.99, 0.01}));
    EXPECT_FALSE(parts.contains({1.01, 0.5, 0.5}));
    EXPECT_FALSE(parts.contains({-3, -3, -3}));
    EXPECT_FALSE(parts.contains({0.5, 2, 0.5}));
}

TEST(ClosedParts, AgreeWithSolidAngles) {
    expect_agreement_with_solid_angles(unit_box(), 1.5, 70);
    expect_agreement_with_solid_angles(ring(), 4.5, 71);
    TriangleMesh overlapping = ring();
    TriangleMesh box;
    add_box(box, {2, -0.5, -0.5}, {6, 0.5, 0.5});
    append(overlapping, box);
    expect_agreement_with_solid_angles(overlapping, 4.5, 72);
}

/// On a grid, where rays hit edges and vertices of the boxes.
TEST(ClosedParts, AgreeWithSolidAnglesOnAGrid) {
    TriangleMesh mesh;
    add_box(mesh, {-2, -2, -2}, {2, 2, 2});
    append(mesh, flipped([] {
               TriangleMesh hollow;
               add_box(hollow, {-1, -1, -1}, {1, 1, 1});
               return hollow;
           }()));
    const support::SolidMesh parts(mesh);
    for (int i = 0; i < 17 * 17 * 17; ++i) {
        const int j = i / 17 % 17;
        const int k = i / 289;
        const Vec3 p(0.37 * (i % 17) - 2.96, 0.37 * j - 2.96, 0.37 * k - 2.96);
        const double farthest = p.cwiseAbs().maxCoeff();
        // The hollow faces inward, so it is not a closed part: its interior belongs to the box.
        ASSERT_EQ(parts.contains(p), farthest < 2.0) << p.transpose();
    }
}

TEST(ClosedParts, LeaveOutPartsWithAnOpenEdge) {
    TriangleMesh mesh = unit_box();
    mesh.triangles.pop_back();
    EXPECT_TRUE(ClosedParts(mesh).empty());
    EXPECT_FALSE(support::SolidMesh(mesh).contains({0.5, 0.5, 0.5}));
    TriangleMesh floor;
    support::add_floor(floor, 5.0, 0.0, 1.0);
    EXPECT_TRUE(ClosedParts(floor).empty());
}

TEST(ClosedParts, LeaveOutPartsThatFaceInward) {
    EXPECT_TRUE(ClosedParts(flipped(unit_box())).empty());
}

TEST(ClosedParts, LeaveOutPartsWithAFlippedTriangle) {
    TriangleMesh mesh = unit_box();
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    EXPECT_TRUE(ClosedParts(mesh).empty());
}

TEST(ClosedParts, AreOnlyTheClosedOnesOfSeveralParts) {
    TriangleMesh mesh = unit_box();
    TriangleMesh open;
    add_box(open, {5, 0, 0}, {6, 1, 1});
    open.triangles.pop_back();
    append(mesh, open);
    const ClosedParts parts(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        EXPECT_EQ(parts.has(t), t < 12) << t;
    }
    EXPECT_EQ(parts.bounds().max, Vec3(1, 1, 1));
    EXPECT_TRUE(support::SolidMesh(mesh).contains({0.5, 0.5, 0.5}));
    EXPECT_FALSE(support::SolidMesh(mesh).contains({5.5, 0.5, 0.5}));
}

TEST(ClosedParts, OfAnEmptyMeshAreEmpty) {
    EXPECT_TRUE(ClosedParts(TriangleMesh{}).empty());
}

TEST(ClosedParts, AreRestoredFromTheirMembersAndBounds) {
    TriangleMesh mesh = unit_box();
    add_quad(mesh, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0});
    const ClosedParts found(mesh);
    const std::size_t count = mesh.triangles.size();
    const ClosedParts taken(found.members(), found.bounds(), count);
    for (std::size_t t = 0; t < count; ++t) {
        EXPECT_EQ(taken.has(t), t < 12) << t;
    }
    EXPECT_EQ(taken.bounds().max, Vec3(1, 1, 1));
    EXPECT_THROW(ClosedParts(found.members(), found.bounds(), 65), std::invalid_argument);
    EXPECT_THROW(ClosedParts(found.members(), {Vec3::Zero(), Vec3::Constant(INFINITY)}, count),
                 std::invalid_argument);
}

/// Vertices at -0 and 0 are in the same place.
TEST(ClosedParts, TreatNegativeZeroAsZero) {
    TriangleMesh mesh = unit_box();
    TriangleMesh own;  // no shared vertices, every second one with its zeros negative
    for (const auto& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(own.positions.size());
        for (const std::uint32_t v : t) {
            Eigen::Vector3f p = mesh.positions[v];
            for (Eigen::Index k = 0; k < 3; ++k) {
                p[k] = p[k] == 0.0F && own.positions.size() % 2 == 0 ? -0.0F : p[k];
            }
            own.positions.push_back(p);
        }
        own.triangles.push_back({first, first + 1, first + 2});
    }
    ASSERT_FALSE(ClosedParts(own).empty());
    EXPECT_TRUE(ClosedParts(own).has(11));
}

}  // namespace
}  // namespace campuswalk::collision
