#include "engine/observers/key_frames.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::engine {

namespace {

constexpr std::size_t kFirstAngle = 3;  // yaw, pitch
constexpr double kRounding = 1e-6;      // units: a straight path's own rounding may not end a piece

double tolerance_of(std::size_t i) {
    return (i < kFirstAngle ? KeyFrames::kHalfUnit : KeyFrames::kAngleUnit) + kRounding;
}

KeyFrame rounded(const PathSample& sample, bool cut) {
    KeyFrame key{sample.tick, {}, cut};
    for (std::size_t i = 0; i < PathSample::kSize; ++i) {
        key.values[i] = static_cast<std::int64_t>(std::floor(sample.values[i] + 0.5));
    }
    return key;
}

}  // namespace

void KeyFrames::add(const PathSample& sample, bool cut) {
    const KeyFrame key = rounded(sample, cut);
    if (cut || !any_) {
        finish();
        sink_(key);
        start_from(key);
        return;
    }
    if (open_ && !fits(key)) {
        const KeyFrame last = rounded(latest_, false);
        sink_(last);
        start_from(last);
    }
    narrow(sample);
    latest_ = sample;
    open_ = true;
}

void KeyFrames::finish() {
    if (open_) {
        sink_(rounded(latest_, false));
        open_ = false;
    }
}

void KeyFrames::start_from(const KeyFrame& key) {
    any_ = true;
    open_ = false;
    from_ = key;
    least_.fill(-1e300);
    most_.fill(1e300);
}

/// Whether the line to `end` passes close enough to every sample before it.
bool KeyFrames::fits(const KeyFrame& end) const {
    const auto ticks = static_cast<double>(end.tick - from_.tick);
    for (std::size_t i = 0; i < PathSample::kSize; ++i) {
        const double slope = static_cast<double>(end.values[i] - from_.values[i]) / ticks;
        if (slope < least_[i] || slope > most_[i]) {
            return false;
        }
    }
    return true;
}

void KeyFrames::narrow(const PathSample& sample) {
    const auto ticks = static_cast<double>(sample.tick - from_.tick);
    for (std::size_t i = 0; i < PathSample::kSize; ++i) {
        const double rise = sample.values[i] - static_cast<double>(from_.values[i]);
        least_[i] = std::max(least_[i], (rise - tolerance_of(i)) / ticks);
        most_[i] = std::min(most_[i], (rise + tolerance_of(i)) / ticks);
    }
}

}  // namespace campuswalk::engine
