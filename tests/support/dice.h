#pragma once

#include <cstdint>
#include <random>

#include <Eigen/Core>

namespace campuswalk::support {

/// Random numbers from the engine's own bits: the standard distributions differ between libraries, and a seed
/// in a failure message must mean the same everywhere.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high) {
        const auto part = static_cast<double>(static_cast<std::uint32_t>(engine_())) / 4294967296.0;
        return low + (high - low) * part;
    }
    /// 0 <= result < count.
    int below(int count) { return static_cast<int>(between(0.0, count)); }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }
    /// In the cube about the origin.
    Eigen::Vector3d in_cube(double half_size) {
        const double x = between(-half_size, half_size);
        const double y = between(-half_size, half_size);
        return {x, y, between(-half_size, half_size)};
    }

private:
    std::mt19937 engine_;
};

}  // namespace campuswalk::support
