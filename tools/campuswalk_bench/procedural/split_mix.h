#pragma once

#include <cstddef>
#include <cstdint>

#include "collision/geometry/shapes.h"

namespace campuswalk::tools::bench {

/// Pseudo-random numbers that are the same on every platform: SplitMix64 by Steele, Lea and Flood (2014).
class SplitMix {
public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    double between(double low, double high) {
        constexpr double kStep = 0x1p-53;
        return low + (high - low) * kStep * static_cast<double>(next() >> 11U);
    }

    /// A number less than `count`.
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(between(0.0, static_cast<double>(count)));
    }

    /// A uniformly distributed unit vector.
    collision::Vec3 direction() {
        while (true) {
            const double x = between(-1.0, 1.0);
            const double y = between(-1.0, 1.0);
            const collision::Vec3 v(x, y, between(-1.0, 1.0));
            if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1.0) {
                return v.normalized();
            }
        }
    }

private:
    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
};

}  // namespace campuswalk::tools::bench
