#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"

/// The course's furniture: poles, balls and benches stand in the way and are walked around.
namespace campuswalk::collision::course {
namespace {

using support::add_box;
using support::add_quad;

/// A pole of triangles, as modellers approximate round ones.
void add_prism(TriangleMesh& mesh, const Vec3& at, double radius, double high, int sides) {
    const auto vertex = [&](int i) { return Vec3(at + radius * towards(360.0 * i / sides)); };
    for (int i = 0; i < sides; ++i) {
        const Vec3 up(0, high, 0);
        add_quad(mesh, vertex(i), vertex(i + 1), vertex(i + 1) + up, vertex(i) + up);
    }
}

void add_bench(TriangleMesh& mesh, const Vec3& at) {
    add_box(mesh, at + Vec3(-0.25, 0.42, -0.9), at + Vec3(0.25, 0.47, 0.9));
    for (const double side : {-0.8, 0.8}) {
        add_box(mesh, at + Vec3(-0.2, 0, side - 0.03), at + Vec3(0.2, 0.42, side + 0.03));
    }
}

struct Furniture {
    const char* name = "";
    void (*put)(World& world, const Vec3& at) = nullptr;
    double half_width = 0.0;  ///< seen from the west, metres
};

template <typename Add>
void put_mesh(World& world, const Add& add) {
    TriangleMesh mesh;
    add(mesh);
    support::add_object(world, std::move(mesh));
}

void PrintTo(const Furniture& piece, std::ostream* out) {
    *out << piece.name;
}

class CourseFurniture : public ::testing::TestWithParam<Furniture> {};

/// How much longer the body's path within `seconds` is than the distance it covers, metres.
double excess_motion(AuditedBody& body, const Vec3& velocity, double seconds) {
    const Vec3 start = body.foot();
    double path = 0.0;
    for (int i = 0; i < seconds * body.ticks_per_second && !::testing::Test::HasFatalFailure(); ++i) {
        const Vec3 before = body.foot();
        body.tick(velocity);
        path += (body.foot() - before).norm();
    }
    return path - (body.foot() - start).norm();
}

bool gets_past(AuditedBody& body, const Vec3& velocity, double seconds) {
    const int ticks = static_cast<int>(seconds * body.ticks_per_second);
    for (int i = 0; i < ticks && body.foot().x() < 3.5 && !::testing::Test::HasFatalFailure(); ++i) {
        body.tick(velocity);
    }
    return body.foot().x() >= 3.5;
}

/// Hit in the middle, it may hold the body still or let it slip around. If it holds the body, walking to one
/// side gets past it.
TEST_P(CourseFurniture, IsWalkedAroundWithoutJitter) {
    const auto world = floor_world();
    GetParam().put(*world, {3, 0, 0});
    AuditedBody body(*world);
    for (const double part : {0.0, 0.25, -0.5, 0.9}) {
        for (const double speed : {1.4, 12.0}) {
            SCOPED_TRACE(testing::Message() << "off the middle by " << part << ", " << speed << " m/s");
            body.stand({1, 0, part * (GetParam().half_width + kRadius)});
            const Vec3 ahead(speed, 0, 0);
            if (!gets_past(body, ahead, 8.0 / speed + 1.0)) {
                EXPECT_LE(excess_motion(body, ahead, 1.0), 5e-4);
                EXPECT_TRUE(gets_past(body, {speed, 0, part < 0.0 ? -speed : speed}, 8.0)) << "it sticks";
            }
            EXPECT_NEAR(body.foot().y(), 0.0, 1e-3) << "never on top of it";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Pieces, CourseFurniture,
    ::testing::Values(
        Furniture{"thin_pole",
                  [](World& world, const Vec3& at) {
                      support::add_object(world, Capsule{0.02, 1.5}, at + Vec3(0, 1.5, 0));
                  },
                  0.02},
        Furniture{"prism_pole",
                  [](World& world, const Vec3& at) {
                      put_mesh(world, [&](TriangleMesh& mesh) { add_prism(mesh, at, 0.15, 3.0, 8); });
                  },
                  0.15},
        Furniture{"fine_column",
                  [](World& world, const Vec3& at) {
                      put_mesh(world, [&](TriangleMesh& mesh) { add_prism(mesh, at, 0.5, 3.0, 64); });
                  },
                  0.5},
        Furniture{"ball",
                  [](World& world, const Vec3& at) {
                      support::add_object(world, Sphere{0.8}, at + Vec3(0, 0.8, 0));
                  },
                  0.5},
        Furniture{"hanging_ball",
                  [](World& world, const Vec3& at) {
                      support::add_object(world, Sphere{0.4}, at + Vec3(0, 1.9, 0));
                  },
                  0.3},
        Furniture{"bench",
                  [](World& world, const Vec3& at) {
                      put_mesh(world, [&](TriangleMesh& mesh) { add_bench(mesh, at); });
                  },
                  0.9},
        Furniture{"box_bench",
                  [](World& world, const Vec3& at) {
                      support::add_object(world, Box{{0.25, 0.225, 0.9}}, at + Vec3(0, 0.225, 0));
                  },
                  0.9}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace campuswalk::collision::course
