#include "tests/support/course/profile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace campuswalk::support {
namespace {

/// The ball's lowest height, from the profile's points in steps of a tenth of a millimetre.
double rolled_by_steps(const Profile& profile, double x, double radius) {
    double highest = -1e300;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const Eigen::Vector2d along = profile[i] - profile[i - 1];
        const int pieces = 1 + static_cast<int>(along.norm() / 1e-4);
        for (int k = 0; k <= pieces; ++k) {
            const Eigen::Vector2d p = profile[i - 1] + k / static_cast<double>(pieces) * along;
            const double off = p.x() - x;
            if (std::abs(off) <= radius) {
                highest = std::max(highest, p.y() + std::sqrt(radius * radius - off * off) - radius);
            }
        }
    }
    return highest;
}

TEST(Profile, RolledHeightAgreesWithSmallSteps) {
    for (const Profile& profile :
         {flight(0.0, 0.17, 0.28, 3), ramp(0.0, 30.0, 1.0), ramp(0.2, 60.0, 0.5), waves(0.5, 0.1, 2, 6)}) {
        for (int i = 0; i <= 66; ++i) {
            const double x = -0.6 + 0.0317 * i;
            EXPECT_NEAR(rolled_height(profile, x, 0.3), rolled_by_steps(profile, x, 0.3), 1e-6) << x;
        }
    }
}

TEST(Profile, RolledHeightIsExactOnLevelGroundAndAtAnEdge) {
    const Profile step = flight(0.0, 0.2, 0.3, 1);
    EXPECT_EQ(rolled_height(step, -1.0, 0.3), 0.0);
    EXPECT_EQ(rolled_height(step, 1.0, 0.3), 0.2);
    EXPECT_NEAR(rolled_height(step, -0.2, 0.3), 0.2 + std::sqrt(0.05) - 0.3, 1e-12) << "beside the edge";
}

}  // namespace
}  // namespace campuswalk::support
