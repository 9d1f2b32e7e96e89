#include "scene/import/source/tangent_frame.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/support/angles.h"

namespace campuswalk::scene {
namespace {

using support::radians;

/// The inverse, which has a closed form by the definition of WGS 84.
Eigen::Vector3d ecef_point(double latitude_deg, double longitude_deg, double height) {
    constexpr double kEquator = 6378137.0;
    constexpr double kFlattening = 1.0 / 298.257223563;
    constexpr double kSquared = kFlattening * (2.0 - kFlattening);
    const double sine = std::sin(radians(latitude_deg));
    const double cosine = std::cos(radians(latitude_deg));
    const double curvature = kEquator / std::sqrt(1.0 - kSquared * sine * sine);
    return {(curvature + height) * cosine * std::cos(radians(longitude_deg)),
            (curvature + height) * cosine * std::sin(radians(longitude_deg)),
            (curvature * (1.0 - kSquared) + height) * sine};
}

TEST(TangentFrame, InvertsTheClosedForm) {
    constexpr double kTenthOfMillimetre = 1e-9;  // degrees
    for (int i = 0; i <= 24; ++i) {
        const double latitude = -90.0 + 7.5 * i;
        for (int j = 0; j <= 10; ++j) {
            const double longitude = -165.0 + 34.5 * j;
            for (const double height : {-400.0, 0.0, 43.25, 8848.0, 90e3}) {
                const auto frame = tangent_frame(ecef_point(latitude, longitude, height));
                ASSERT_TRUE(frame) << latitude << ' ' << longitude << ' ' << height;
                EXPECT_NEAR(frame->place.latitude_deg, latitude, kTenthOfMillimetre);
                EXPECT_NEAR(frame->place.height, height, 1e-6);
                if (std::abs(latitude) < 90.0) {
                    EXPECT_NEAR(frame->place.longitude_deg, longitude, kTenthOfMillimetre);
                }
            }
        }
    }
}

TEST(TangentFrame, MapsEastUpAndSouthToItsAxes) {
    const auto frame = tangent_frame(ecef_point(52.0, 4.375, 10.0));
    ASSERT_TRUE(frame);
    const Eigen::Matrix3d& R = frame->R_local_ecef;
    EXPECT_TRUE((R * R.transpose()).isIdentity(1e-15));
    EXPECT_NEAR(R.determinant(), 1.0, 1e-15);
    const auto seen = [&](double latitude, double longitude, double height) {
        return Eigen::Vector3d(R * (ecef_point(latitude, longitude, height) - ecef_point(52.0, 4.375, 10.0)));
    };
    EXPECT_TRUE(seen(52.0, 4.375, 11.0).isApprox(Eigen::Vector3d(0, 1, 0), 1e-8));
    EXPECT_NEAR(seen(52.0, 4.376, 10.0).normalized().x(), 1.0, 1e-6);
    EXPECT_NEAR(seen(52.001, 4.375, 10.0).normalized().z(), -1.0, 1e-6);
}

TEST(TangentFrame, RejectsPointsFarFromTheSurface) {
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(84500, 447400, 0), Eigen::Vector3d(6378137, 200e3, 3e6),
          Eigen::Vector3d(1e308, 1e308, 1e308)}) {
        EXPECT_FALSE(tangent_frame(point)) << point.transpose();
    }
}

}  // namespace
}  // namespace campuswalk::scene
