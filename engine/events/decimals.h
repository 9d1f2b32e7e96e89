#pragma once

#include <cstdint>
#include <numbers>
#include <string>

#include <Eigen/Core>

namespace campuswalk::engine {

/// `value` with a fixed number of decimals (80 at most), in any locale; what rounds to zero has no sign.
std::string fixed(double value, int digits);
/// `x,y,z` with three decimals.
std::string fixed(const Eigen::Vector3d& value);
/// `x, y, z` with two decimals, as messages say where something is; logs have `fixed`.
std::string coordinates_text(const Eigen::Vector3d& place);

/// Sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t value);

/// Angles are printed in degrees.
constexpr double degrees(double radians) {
    return radians * (180.0 / std::numbers::pi);
}

}  // namespace campuswalk::engine
