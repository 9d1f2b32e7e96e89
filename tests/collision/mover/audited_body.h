#pragma once

#include "collision/mover/mover.h"
#include "tests/support/penetration_oracle.h"

namespace campuswalk::collision {

/// A body that fails the test if the mover fails: the penetration oracle checks the end of every tick and
/// every straight segment of its motion.
class AuditedBody {
public:
    explicit AuditedBody(const World& world, const MoverSettings& settings = {},
                         const QueryFilter& filter = {});

    /// Puts the body on the ground up to `search` metres below `foot`, otherwise in the air at `foot`.
    void stand(const Vec3& foot, double search = 0.5);
    /// One tick with this horizontal velocity, metres per second.
    void tick(const Vec3& velocity);
    void walk(const Vec3& velocity, double seconds);
    /// Ticks until the body stands on something; fails after ten seconds.
    void fall_down();

    const Vec3& foot() const { return state_.foot; }
    MoverState& state() { return state_; }
    const MoveTrace& trace() const { return trace_; }
    bool touches(ObjectId id) const;
    /// Ticks since `stand` after which the body was in the air.
    int ticks_in_air() const { return ticks_in_air_; }

    double ticks_per_second = 60.0;

private:
    void audit() const;

    MoverSettings settings_;
    support::PenetrationOracle oracle_;
    CapsuleMover mover_;
    MoverCache cache_;
    MoverState state_;
    MoveTrace trace_;
    int ticks_in_air_ = 0;
};

}  // namespace campuswalk::collision
