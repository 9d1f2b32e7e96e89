#pragma once

#include <cstdint>
#include <functional>

#include "collision/mover/mover.h"
#include "tests/support/penetration_oracle.h"

namespace campuswalk::support {

/// One tick of a body: a mover to test, correct or broken.
using MoveBody = std::function<void(collision::MoverState& state, const collision::Vec3& desired,
                                    double seconds, collision::MoveTrace& trace)>;

struct WalkSettings {
    collision::Vec3 start = collision::Vec3::Zero();  ///< a free place
    std::uint32_t seed = 0;
    int ticks = 600;
    double ticks_per_second = 60.0;
    double fastest = 3.0;  ///< metres per second
    double radius = 0.3;   ///< of the body that must not overlap anything
    double height = 1.8;
};

/// What the oracle found on a walk.
struct WalkAudit {
    Penetration deepest{-PenetrationOracle::kClear, std::nullopt};
    int ticks_inside = 0;       ///< deeper than kAllowed at their end
    int crossings = 0;          ///< segments on which the axis passed through something
    bool finite = true;         ///< every coordinate was a number
    double distance = 0.0;      ///< metres walked and fallen
    std::uint64_t digest = 0;   ///< of the bits of every position and speed
    collision::MoverState end;  ///< where it ended

    /// Allowance for rounding, metres.
    static constexpr double kAllowed = 1e-6;
    bool clean() const { return ticks_inside == 0 && crossings == 0 && finite; }
};

/// A walk at random headings and speeds, each kept for some time, that bumps into whatever is there; the
/// oracle checks the end of every tick and every straight segment of its motion.
WalkAudit audit_random_walk(const PenetrationOracle& oracle, const MoveBody& move,
                            const WalkSettings& settings);

}  // namespace campuswalk::support
