#include "collision/mover/half_planes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

std::vector<HalfPlane> random_planes(Dice& dice, int count) {
    std::vector<HalfPlane> planes;
    for (int i = 0; i < count; ++i) {
        const double angle = dice.between(0.0, 6.3);
        planes.push_back({std::cos(angle), std::sin(angle), dice.chance(0.3) ? 0.0 : dice.between(0.0, 0.5)});
    }
    return planes;
}

using Planes = std::vector<HalfPlane>;

TEST(HalfPlanes, LeaveAnAllowedDisplacementUnchanged) {
    EXPECT_EQ(nearest_allowed({0.3, 0, -0.1}, {}), Vec3(0.3, 0, -0.1));
    EXPECT_EQ(nearest_allowed({0.3, 0, -0.1}, Planes{{1, 0, 0.0}}), Vec3(0.3, 0, -0.1));
}

TEST(HalfPlanes, LeaveTheComponentAlongAWall) {
    EXPECT_TRUE(nearest_allowed({-0.3, 0, 0.2}, Planes{{1, 0, 0.0}}).isApprox(Vec3(0, 0, 0.2)));
    EXPECT_TRUE(nearest_allowed({-0.3, 0, 0.2}, Planes{{1, 0, 0.1}}).isApprox(Vec3(-0.1, 0, 0.2)));
}

/// Compares with the allowed points of a fine grid.
TEST(HalfPlanes, NoAllowedPointIsNearerThanTheResult) {
    Dice dice(5);
    for (int i = 0; i < support::repeats(500); ++i) {
        const auto planes = random_planes(dice, 1 + i % 6);
        const Vec3 desired(dice.between(-0.4, 0.4), 0, dice.between(-0.4, 0.4));
        const Vec3 found = nearest_allowed(desired, planes);
        for (const HalfPlane& p : planes) {
            ASSERT_GE(p.x * found.x() + p.z * found.z(), -p.room - 1e-11);
        }
        const double distance = (found - desired).norm();
        for (int x = -60; x <= 60; ++x) {
            for (int z = -60; z <= 60; ++z) {
                const Vec3 other(x / 100.0, 0, z / 100.0);
                const bool fits = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& p) {
                    return p.x * other.x() + p.z * other.z() >= -p.room;
                });
                ASSERT_TRUE(!fits || (other - desired).norm() >= distance - 1e-11) << i;
            }
        }
    }
}

/// The nearest allowed of all moves that could be it: to the last bit, so that no shortcut drops one.
Vec3 nearest_of_all(const Vec3& desired, const Planes& planes) {
    Vec3 best = Vec3::Zero();
    const auto offer = [&](const Vec3& move) {
        const double distance = (desired - move).squaredNorm();
        const double least = (desired - best).squaredNorm();
        const bool ahead = move.x() != best.x() ? move.x() < best.x() : move.z() < best.z();
        if ((distance < least || (distance == least && ahead)) &&
            std::ranges::all_of(planes, [&](const HalfPlane& p) { return p.allows(move); })) {
            best = move;
        }
    };
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const HalfPlane& p = planes[i];
        const double away = -p.room - (p.x * desired.x() + p.z * desired.z());
        offer({desired.x() + away * p.x, 0, desired.z() + away * p.z});
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const HalfPlane& q = planes[j];
            const double determinant = p.x * q.z - p.z * q.x;
            if (std::abs(determinant) > 1e-9) {
                offer({(-p.room * q.z + q.room * p.z) / determinant, 0,
                       (-q.room * p.x + p.room * q.x) / determinant});
            }
        }
    }
    return best;
}

TEST(HalfPlanes, OfManyNoneIsDroppedThatMatters) {
    Dice dice(7);
    int held = 0;
    for (int i = 0; i < support::repeats(5000); ++i) {
        Planes planes = random_planes(dice, 1 + i % 60);
        for (HalfPlane& p : planes) {
            p.room *= 0.1;
            if (dice.chance(0.3)) {  // nearly parallel to another, as faces of a round thing are
                const HalfPlane& other = planes[static_cast<std::size_t>(i) % planes.size()];
                const double turn = dice.between(-1e-8, 1e-8);
                p = {other.x - turn * other.z, other.z + turn * other.x, other.room};
            }
        }
        const Vec3 desired(dice.between(-0.03, 0.03), 0, dice.between(-0.03, 0.03));
        const Vec3 found = nearest_allowed(desired, planes);
        if (std::ranges::all_of(planes, [&](const HalfPlane& p) { return p.allows(desired); })) {
            ASSERT_EQ(found, desired) << i;
        } else {
            ++held;
            ASSERT_EQ(found, nearest_of_all(desired, planes)) << i;
        }
    }
    EXPECT_GT(held, support::repeats(5000) / 2);
}

TEST(HalfPlanes, TheirOrderDoesNotMatter) {
    Dice dice(6);
    for (int i = 0; i < 2000; ++i) {
        auto planes = random_planes(dice, 4);
        const Vec3 desired(dice.between(-0.4, 0.4), 0, dice.between(-0.4, 0.4));
        const Vec3 found = nearest_allowed(desired, planes);
        std::reverse(planes.begin(), planes.end());
        const Vec3 other = nearest_allowed(desired, planes);
        ASSERT_LT((found - other).norm(), 1e-12) << i;
    }
    // Two equally near results.
    const std::vector<HalfPlane> gate{{0.6, 0.8, 0.0}, {0.6, -0.8, 0.0}};
    const std::vector<HalfPlane> turned{gate[1], gate[0]};
    EXPECT_EQ(nearest_allowed({-0.1, 0, 0}, gate), nearest_allowed({-0.1, 0, 0}, turned));
}

}  // namespace
}  // namespace campuswalk::collision
