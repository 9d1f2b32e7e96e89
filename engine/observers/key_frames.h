#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// Where the avatar was at a tick, in the units that recordings store: x, y, z in millimetres, yaw and pitch
/// in tenths of a degree.
struct PathSample {
    static constexpr std::size_t kSize = 5;
    Tick tick = 0;
    std::array<double, kSize> values = {};
};

/// A sample in whole units, and whether the avatar was put there instead of moving there.
struct KeyFrame {
    Tick tick = 0;
    std::array<std::int64_t, PathSample::kSize> values = {};
    bool cut = false;
};

/// Thins a path where it is straight: between two key frames of which the second isn't a cut, every sample
/// lies close to the straight line: positions within kHalfUnit, angles within kAngleUnit.
/// One sample at a time, without looking back.
class KeyFrames {
public:
    using Sink = std::function<void(const KeyFrame&)>;
    /// Of positions, from the exact ones: half a millimetre. Logs round them by as much, so that a reader's
    /// positions are those of the log to a millimetre.
    static constexpr double kHalfUnit = 0.5;
    static constexpr double kAngleUnit = 1.0;

    explicit KeyFrames(Sink sink) : sink_(std::move(sink)) {}

    /// Ticks ascend by one. `cut`: the avatar was put there.
    void add(const PathSample& sample, bool cut);
    /// After the last sample.
    void finish();

private:
    void start_from(const KeyFrame& key);
    bool fits(const KeyFrame& end) const;
    void narrow(const PathSample& sample);

    Sink sink_;
    bool any_ = false;
    KeyFrame from_;      ///< the last one that was emitted
    PathSample latest_;  ///< the sample after which nothing was emitted yet
    bool open_ = false;  ///< there is such a sample
    /// The slopes, units per tick, of lines from `from_` that pass close enough to every sample since.
    std::array<double, PathSample::kSize> least_ = {};
    std::array<double, PathSample::kSize> most_ = {};
};

}  // namespace campuswalk::engine
