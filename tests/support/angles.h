#pragma once

#include <numbers>

namespace campuswalk::support {

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

}  // namespace campuswalk::support
