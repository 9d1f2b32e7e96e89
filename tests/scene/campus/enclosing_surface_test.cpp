#include "scene/campus/enclosing_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "collision/mesh/mesh_query.h"
#include "scene/campus/bake_mesh.h"
#include "scene/campus/polygon_ears.h"
#include "tests/support/dice.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

/// Facing outward, eight vertices.
void add_box(WorldGeometry& to, const Vector3d& min, const Vector3d& max) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (int i = 0; i < 8; ++i) {
        to.positions.emplace_back((i & 1) != 0 ? max.x() : min.x(), (i & 2) != 0 ? max.y() : min.y(),
                                  (i & 4) != 0 ? max.z() : min.z());
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : kFaces) {
        to.triangles.push_back({first + f[0], first + f[1], first + f[2]});
        to.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    }
}

WorldGeometry room() {
    WorldGeometry geometry;
    add_box(geometry, {-5, -1, -5}, {5, 6, 5});
    return geometry;
}

void turn_round(std::array<std::uint32_t, 3>& triangle) {
    std::swap(triangle[1], triangle[2]);
}

bool contains(const EnclosingSurface& surface, const Vector3d& point) {
    const BakedMesh baked = bake_every_triangle(surface.geometry);
    const collision::MeshCollider mesh(collision::TriangleMesh(baked.mesh));
    return collision::is_inside(mesh, point - baked.p_world_origin);
}

/// Whether a point is inside of the surface exactly when it is in the room.
void expect_room(const EnclosingSurface& surface) {
    ASSERT_FALSE(surface.no_inside);
    support::Dice dice(7);
    for (int i = 0; i < 300; ++i) {
        const Vector3d p(dice.between(-7, 7), dice.between(-3, 8), dice.between(-7, 7));
        const double depth = std::min({5 - std::abs(p.x()), 5 - std::abs(p.z()), p.y() + 1, 6 - p.y()});
        if (std::abs(depth) > 0.01) {
            ASSERT_EQ(contains(surface, p), depth > 0.0) << p.transpose();
        }
    }
}

TEST(EnclosingSurface, TurnsWhatFacesInwardOrInBothDirections) {
    WorldGeometry inward = room();
    std::ranges::for_each(inward.triangles, turn_round);
    expect_room(enclosing_surface(inward));
    WorldGeometry mixed = room();
    for (std::size_t i = 0; i < mixed.triangles.size(); i += 3) {
        turn_round(mixed.triangles[i]);
    }
    expect_room(enclosing_surface(mixed));
}

TEST(EnclosingSurface, LeavesOutFacesThatAreThereTwice) {
    for (const bool reversed : {false, true}) {
        WorldGeometry doubled = room();
        auto again = doubled.triangles;
        if (reversed) {
            std::ranges::for_each(again, turn_round);
        }
        doubled.triangles.insert(doubled.triangles.end(), again.begin(), again.end());
        const EnclosingSurface surface = enclosing_surface(doubled);
        expect_room(surface);
        EXPECT_EQ(surface.geometry.triangles.size(), 12U);
        EXPECT_EQ(surface.openings, 0U);
    }
}

TEST(EnclosingSurface, JoinsVerticesThatAreNearlyThere) {
    const WorldGeometry welded = room();
    support::Dice dice(3);
    WorldGeometry loose;
    for (const auto& triangle : welded.triangles) {
        for (const std::uint32_t vertex : triangle) {
            const Vector3d off(dice.between(-2e-4, 2e-4), dice.between(-2e-4, 2e-4),
                               dice.between(-2e-4, 2e-4));
            loose.positions.push_back(welded.positions[vertex] + off);
        }
        const auto last = static_cast<std::uint32_t>(loose.positions.size());
        loose.triangles.push_back({last - 3, last - 2, last - 1});
    }
    const EnclosingSurface surface = enclosing_surface(loose);
    expect_room(surface);
    EXPECT_EQ(surface.openings, 0U);
}

TEST(EnclosingSurface, ClosesOpeningsWithAFlatRim) {
    WorldGeometry without_roof = room();
    without_roof.triangles.erase(without_roof.triangles.begin() + 6, without_roof.triangles.begin() + 8);
    const EnclosingSurface roofed = enclosing_surface(without_roof);
    expect_room(roofed);
    EXPECT_EQ(roofed.openings, 1U);
    WorldGeometry walls = without_roof;
    walls.triangles.erase(walls.triangles.begin() + 4, walls.triangles.begin() + 6);
    const EnclosingSurface both = enclosing_surface(walls);
    expect_room(both);
    EXPECT_EQ(both.openings, 2U);
    WorldGeometry torn = room();
    torn.triangles.pop_back();
    expect_room(enclosing_surface(torn));
}

/// Walls without a roof and a floor around an L.
TEST(EnclosingSurface, ClosesOpeningsThatAreNotConvex) {
    const std::array<Vector3d, 6> plan = {Vector3d(0, 0, 0),  Vector3d(0, 0, 10), Vector3d(10, 0, 10),
                                          Vector3d(10, 0, 6), Vector3d(4, 0, 6),  Vector3d(4, 0, 0)};
    WorldGeometry walls;
    for (const Vector3d& p : plan) {
        walls.positions.push_back(p);
        walls.positions.push_back(p + Vector3d(0, 3, 0));
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t a = 2 * i;
        const std::uint32_t b = 2 * ((i + 1) % 6);
        walls.triangles.push_back({a, b, b + 1});
        walls.triangles.push_back({a, b + 1, a + 1});
    }
    const EnclosingSurface surface = enclosing_surface(walls);
    ASSERT_FALSE(surface.no_inside);
    EXPECT_EQ(surface.openings, 2U);
    for (const auto& [x, z, inside] : {std::tuple(2.0, 3.0, true),
                                       {8.0, 8.0, true},
                                       {2.0, 8.0, true},
                                       {8.0, 3.0, false},
                                       {-1.0, 3.0, false}}) {
        EXPECT_EQ(contains(surface, {x, 1.5, z}), inside) << x << ", " << z;
    }
}

TEST(EnclosingSurface, CountsWhatIsInAnyPart) {
    WorldGeometry thick = room();  // an outer shell, and an inner one that faces into the room
    WorldGeometry inner;
    add_box(inner, {-4.7, -0.7, -4.7}, {4.7, 5.7, 4.7});
    for (auto triangle : inner.triangles) {
        turn_round(triangle);
        thick.triangles.push_back({triangle[0] + 8, triangle[1] + 8, triangle[2] + 8});
    }
    thick.positions.insert(thick.positions.end(), inner.positions.begin(), inner.positions.end());
    expect_room(enclosing_surface(thick));

    WorldGeometry with_sign = room();  // a sheet on its wall
    const auto first = static_cast<std::uint32_t>(with_sign.positions.size());
    for (const Vector3d& p : {Vector3d(5, 6, 5), Vector3d(9, 6, 5), Vector3d(9, 2, 5)}) {
        with_sign.positions.push_back(p);
    }
    with_sign.triangles.push_back({first, first + 1, first + 2});
    const EnclosingSurface surface = enclosing_surface(with_sign);
    expect_room(surface);
    EXPECT_EQ(surface.geometry.triangles.size(), 12U);
    EXPECT_EQ(surface.left_out, 1U);
}

TEST(EnclosingSurface, SaysWhyNothingIsInside) {
    WorldGeometry sheet;
    sheet.positions = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(enclosing_surface(sheet).no_inside, NoInside::flat);

    WorldGeometry hills;  // whose rim goes up and down
    for (std::uint32_t i = 0; i < 25; ++i) {
        const double x = i % 5;
        const double z = i / 5;
        hills.positions.emplace_back(x, std::sin(2 * x) + std::cos(3 * z), z);
        if (i % 5 < 4 && i < 20) {
            hills.triangles.push_back({i, i + 5, i + 1});
            hills.triangles.push_back({i + 1, i + 5, i + 6});
        }
    }
    EXPECT_EQ(enclosing_surface(hills).no_inside, NoInside::open);

    WorldGeometry fins;  // three sheets that share an edge
    fins.positions = {{0, 0, 0}, {0, 3, 0}, {1, 0, 0}, {-1, 0, 1}, {-1, 0, -1}};
    fins.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    EXPECT_EQ(enclosing_surface(fins).no_inside, NoInside::branching);
}

TEST(EnclosingSurface, LeavesWhatIsTooLarge) {
    WorldGeometry many;
    many.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    many.triangles.assign(kMostClosedFaces + 1, {0, 1, 2});
    EXPECT_EQ(enclosing_surface(many).no_inside, NoInside::too_large);

    WorldGeometry tube;  // with rims of 2,000 vertices
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const double angle = 2 * M_PI * i / 2000;
        tube.positions.emplace_back(9 * std::cos(angle), 0, 9 * std::sin(angle));
        tube.positions.emplace_back(9 * std::cos(angle), 3, 9 * std::sin(angle));
        const std::uint32_t next = 2 * ((i + 1) % 2000);
        tube.triangles.push_back({2 * i, 2 * i + 1, next + 1});
        tube.triangles.push_back({2 * i, next + 1, next});
    }
    EXPECT_EQ(enclosing_surface(tube).no_inside, NoInside::open);
}

TEST(PolygonEars, CoverThePolygonOnce) {
    support::Dice dice(5);
    for (int round = 0; round < 200; ++round) {
        // A star about the origin is simple, whatever its radii.
        std::vector<Vector3d> points;
        double area = 0.0;
        const int count = 3 + static_cast<int>(dice.below(12));
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * M_PI * i / count;
            const double radius = dice.between(0.2, 3.0);
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1.0);
        }
        for (int i = 0; i < count; ++i) {
            const Vector3d& a = points[static_cast<std::size_t>(i)];
            const Vector3d& b = points[static_cast<std::size_t>((i + 1) % count)];
            area += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
        double covered = 0.0;
        const auto ears = polygon_ears(points, {0, 0, 1});
        ASSERT_EQ(ears.size(), points.size() - 2);
        for (const auto& [a, b, c] : ears) {
            const double ear = 0.5 * (points[b] - points[a]).cross(points[c] - points[a]).z();
            EXPECT_GE(ear, -1e-12);
            covered += ear;
        }
        EXPECT_NEAR(covered, area, 1e-9);
    }
    EXPECT_TRUE(polygon_ears({{0, 0, 0}, {1, 0, 0}}, {0, 0, 1}).empty());
}

}  // namespace
}  // namespace campuswalk::scene
