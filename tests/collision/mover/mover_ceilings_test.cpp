#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/collision/mover/audited_body.h"
#include "tests/support/angles.h"
#include "tests/support/mesh_pieces.h"

/// Ceilings over slopes and stairs: what fits uphill fits downhill.
namespace campuswalk::collision {
namespace {

using support::radians;

/// A course along +Z: a floor, a ramp of 6 m from z = 0 on, a landing.
class Course {
public:
    explicit Course(double slope_deg) : rise_(std::tan(radians(slope_deg))) {
        quad({-3, 0, -4}, {-3, 0, 0}, {3, 0, 0}, {3, 0, -4});
        quad({-3, 0, 0}, {-3, 6 * rise_, 6}, {3, 6 * rise_, 6}, {3, 0, 0});
        quad({-3, 6 * rise_, 6}, {-3, 6 * rise_, 10}, {3, 6 * rise_, 10}, {3, 6 * rise_, 6});
    }

    /// Metres above the ramp, vertically.
    void ceiling(double clearance) {
        const double low = 1.5 * rise_ + clearance;
        const double high = 4.5 * rise_ + clearance;
        quad({-3, low, 1.5}, {3, low, 1.5}, {3, high, 4.5}, {-3, high, 4.5});
    }
    /// A level beam whose uphill edge, the one that is nearer to the ramp, is so far above it.
    void beam(double clearance) {
        const double y = 3.2 * rise_ + clearance;
        quad({-3, y, 3}, {3, y, 3}, {3, y, 3.2}, {-3, y, 3.2});
        quad({-3, y, 3}, {-3, y + 1, 3}, {3, y + 1, 3}, {3, y, 3});
        quad({-3, y, 3.2}, {3, y, 3.2}, {3, y + 1, 3.2}, {-3, y + 1, 3.2});
    }

    /// Whether the body gets from one end to the other, in the course turned by `yaw_deg` about the Y axis.
    bool is_passed(bool uphill, double yaw_deg, bool mirrored) const {
        const Mat3 turn = turned(yaw_deg, mirrored);
        TriangleMesh mesh;
        for (const std::array<Vec3, 4>& q : quads_) {
            support::add_quad(mesh, turn * q[0], turn * q[1], turn * q[2], turn * q[3]);
        }
        World world{std::make_unique<LinearBroadPhase>()};
        support::add_object(world, mesh);
        AuditedBody body(world);
        const double top = 6 * rise_;
        const Vec3 start = uphill ? Vec3(0.3, 0, -2) : Vec3(0.3, top, 8);
        const Vec3 end = uphill ? Vec3(0.3, top, 8) : Vec3(0.3, 0, -2);
        body.stand(turn * start);
        body.walk(turn * Vec3(0, 0, uphill ? 1.4 : -1.4), 8.0);
        return (body.foot() - turn * end).norm() < 1.3;
    }

private:
    static Mat3 turned(double yaw_deg, bool mirrored) {
        const double c = std::cos(radians(yaw_deg));
        const double s = std::sin(radians(yaw_deg));
        Mat3 turn;
        turn << c, 0, s, 0, 1, 0, -s, 0, c;
        return mirrored ? Mat3(turn * Vec3(-1, 1, 1).asDiagonal()) : turn;
    }
    void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) { quads_.push_back({a, b, c, d}); }

    double rise_;
    std::vector<std::array<Vec3, 4>> quads_;
};

/// The least vertical clearance over a ramp: below the foot the lower sphere touches it, the upper one the
/// ceiling.
double least_clearance(const MoverSettings& body, double slope_deg) {
    return body.height - 2.0 * body.radius + 2.0 * body.radius / std::cos(radians(slope_deg));
}

void expect_passed_from(double millimetres, const std::function<void(Course&, double)>& add) {
    for (const double slope : {10.0, 20.0, 30.0, 40.0, 48.0}) {
        const double least = least_clearance(MoverSettings(), slope);
        for (const double yaw : {0.0, 37.0, 90.0}) {
            for (const bool uphill : {true, false}) {
                for (const bool mirrored : {false, true}) {
                    SCOPED_TRACE(std::to_string(slope) + " degrees, yaw " + std::to_string(yaw) +
                                 (uphill ? ", up" : ", down") + (mirrored ? ", mirrored" : ""));
                    Course wide(slope);
                    add(wide, least + millimetres / 1000.0);
                    EXPECT_TRUE(wide.is_passed(uphill, yaw, mirrored));
                    Course narrow(slope);
                    add(narrow, least - 0.001);
                    EXPECT_FALSE(narrow.is_passed(uphill, yaw, mirrored));
                }
            }
        }
    }
}

TEST(MoverUnderCeilings, ARampUnderAParallelCeilingIsPassedInBothDirections) {
    expect_passed_from(1.0, [](Course& course, double clearance) { course.ceiling(clearance); });
}

TEST(MoverUnderCeilings, ALowDoorOnARampIsPassedInBothDirections) {
    expect_passed_from(1.0, [](Course& course, double clearance) { course.beam(clearance); });
}

/// Fifteen steps along +X under a ceiling that is parallel to the line of the nosings, so far above it.
bool stairs_are_passed(double clearance, bool up, double aside, double ticks_per_second) {
    constexpr double kRiser = 0.17;
    constexpr double kTread = 0.28;
    TriangleMesh mesh;
    support::add_floor(mesh, 40.0);
    support::add_stairs(mesh, 0.0, -3.0, 6.0, kRiser, kTread, 15);
    const double low = kRiser + 1.0 * kRiser / kTread + clearance;
    const double high = kRiser + 3.0 * kRiser / kTread + clearance;
    support::add_quad(mesh, {1, low, -3}, {3, high, -3}, {3, high, 3}, {1, low, 3});
    World world{std::make_unique<LinearBroadPhase>()};
    support::add_object(world, mesh);
    AuditedBody body(world);
    body.ticks_per_second = ticks_per_second;
    const Vec3 bottom(-1.5, 0, -aside);
    const Vec3 top(4.7, 15 * kRiser, aside);
    const Vec3 path = up ? Vec3(top - bottom) : Vec3(bottom - top);
    const Vec3 ahead = Vec3(path.x(), 0, path.z()).normalized();
    body.stand(up ? bottom : top);
    body.walk(1.4 * ahead, 5.0);
    return up ? body.foot().x() > 4.2 : body.foot().x() < -1.0;
}

TEST(MoverUnderCeilings, StairsUnderAParallelCeilingArePassedInBothDirections) {
    const double least = least_clearance(MoverSettings(), std::atan2(0.17, 0.28) * 180.0 / M_PI);
    for (const bool up : {true, false}) {
        for (const double aside : {0.0, 1.5}) {
            SCOPED_TRACE(std::string(up ? "up" : "down") + (aside > 0.0 ? ", across" : ""));
            EXPECT_TRUE(stairs_are_passed(least + 0.002, up, aside, 60.0));
            EXPECT_TRUE(stairs_are_passed(least + 0.005, up, aside, 20.0))
                << "a nosing is rolled over in fewer parts";
            EXPECT_FALSE(stairs_are_passed(least - 0.001, up, aside, 60.0));
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision
