#pragma once

#include <array>
#include <cmath>

namespace campuswalk::engine::render {

/// The transfer function of IEC 61966-2-1 and its inverse, 0 to 1.
inline double srgb_to_linear(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}
inline double linear_to_srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Linear values of all 8-bit sRGB values.
inline const std::array<double, 256>& linear_by_srgb_byte() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = srgb_to_linear(static_cast<double>(i) / 255.0);
        }
        return values;
    }();
    return table;
}

}  // namespace campuswalk::engine::render
