#include "engine/observers/key_frames.h"

#include <algorithm>

namespace campuswalk::engine {

namespace {

constexpr std::size_t kFirstAngle = 3;  // yaw, pitch
constexpr double kRounding = 1e-6;      // units: a straight path's own rounding may not end a piece

double tolerance_of(std::size_t i) {
    return (i < kFirstAngle ? KeyFrames::kHalfUnit : KeyFrames::kAngleUnit) + kRounding;
}

/// To the nearest; halves up. std::floor is a call where the processor is any x86-64, five for each tick.
std::int64_t whole(double value) {
    const double raised = value + 0.5;
    const auto truncated = static_cast<std::int64_t>(raised);
    return truncated - (static_cast<double>(truncated) > raised ? 1 : 0);
}

KeyFrame rounded(const PathSample& sample, bool cut) {
    KeyFrame key{sample.tick, {}, cut};
    for (std::size_t i = 0; i < PathSample::kSize; ++i) {
        key.values[i] = whole(sample.values[i]);
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
    const double per_tick = 1.0 / static_cast<double>(end.tick - from_.tick);
    for (std::size_t i = 0; i < PathSample::kSize; ++i) {
        const double slope = static_cast<double>(end.values[i] - from_.values[i]) * per_tick;
        if (slope < least_[i] || slope > most_[i]) {
            return false;
        }
    }
    return true;
}

void KeyFrames::narrow(const PathSample& sample) {
    const double per_tick = 1.0 / static_cast<double>(sample.tick - from_.tick);
    for (std::size_t i = 0; i < PathSample::kSize; ++i) {
        const double rise = sample.values[i] - static_cast<double>(from_.values[i]);
        least_[i] = std::max(least_[i], (rise - tolerance_of(i)) * per_tick);
        most_[i] = std::min(most_[i], (rise + tolerance_of(i)) * per_tick);
    }
}

}  // namespace campuswalk::engine
