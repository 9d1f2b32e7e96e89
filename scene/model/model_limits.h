#pragma once

#include <cstddef>
#include <cstdint>

namespace campuswalk::scene {

// Models come from strangers: a kilobyte may ask for a billion of anything. All are beyond what can be walked
// in a day's work of a machine with 8 GB.

inline constexpr std::size_t kMaxScenes = 1'000;     ///< of a campus
inline constexpr std::size_t kMaxNodes = 1'000'000;  ///< of a model, each instance one
inline constexpr std::size_t kMaxTriangles =
    50'000'000;  ///< placed by a model, and in the colliders of a campus

/// The most bytes of memory for all models of a campus.
inline constexpr std::uint64_t kMaxModelBytes = std::uint64_t{8} << 30U;

inline constexpr double kMaxReach = 1e11;  ///< of a model's nodes, metres: 100 million km

}  // namespace campuswalk::scene
