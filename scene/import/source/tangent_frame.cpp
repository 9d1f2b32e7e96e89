#include "scene/import/source/tangent_frame.h"

#include <cmath>
#include <numbers>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene {
namespace {

// WGS 84: semi-major axis and flattening.
constexpr double kEquator = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kPole = kEquator * (1.0 - kFlattening);
constexpr double kSquaredEccentricity = kFlattening * (2.0 - kFlattening);
constexpr double kSecondSquaredEccentricity = kSquaredEccentricity / (1.0 - kSquaredEccentricity);
constexpr double kMaxHeight = 100e3;  // metres, above or below

struct Direction {
    double sine = 0.0;
    double cosine = 1.0;
};

Direction direction_of(double y, double x) {
    const double length = std::sqrt(x * x + y * y);
    return length > 0.0 ? Direction{y / length, x / length} : Direction{};
}

/// B. R. Bowring's iteration for the latitude (Survey Review 23, 1976), with sine and cosine instead of
/// angles. Near the surface it converges to the last bits in the second round.
Direction latitude_of(double z, double from_axis) {
    Direction reduced = direction_of(z * kEquator, from_axis * kPole);
    Direction latitude;
    for (int round = 0; round < 3; ++round) {
        const auto cube = [](double x) { return x * x * x; };
        latitude = direction_of(z + kSecondSquaredEccentricity * kPole * cube(reduced.sine),
                                from_axis - kSquaredEccentricity * kEquator * cube(reduced.cosine));
        reduced = direction_of((1.0 - kFlattening) * latitude.sine, latitude.cosine);
    }
    return latitude;
}

}  // namespace

std::optional<TangentFrame> tangent_frame(const Eigen::Vector3d& p_ecef) {
    const double from_axis = std::sqrt(p_ecef.x() * p_ecef.x() + p_ecef.y() * p_ecef.y());
    const Direction latitude = latitude_of(p_ecef.z(), from_axis);
    const Direction longitude = direction_of(p_ecef.y(), p_ecef.x());
    const double height = from_axis * latitude.cosine + p_ecef.z() * latitude.sine -
                          kEquator * std::sqrt(1.0 - kSquaredEccentricity * latitude.sine * latitude.sine);
    if (!(std::abs(height) <= kMaxHeight)) {
        return std::nullopt;
    }
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    TangentFrame frame;
    frame.place.latitude_deg = collision::angle_of(latitude.sine, latitude.cosine) * kDegrees;
    frame.place.longitude_deg = collision::angle_of(longitude.sine, longitude.cosine) * kDegrees;
    frame.place.height = height;
    frame.R_local_ecef << -longitude.sine, longitude.cosine, 0.0,  //
        latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine,
        latitude.sine * longitude.cosine, latitude.sine * longitude.sine, -latitude.cosine;
    return frame;
}

}  // namespace campuswalk::scene
