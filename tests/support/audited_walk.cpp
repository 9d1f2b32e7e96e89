#include "tests/support/audited_walk.h"

#include <bit>
#include <cmath>
#include <numbers>

#include "tests/support/dice.h"

namespace campuswalk::support {

namespace {

using collision::MoverState;
using collision::MoveTrace;
using collision::Vec3;

void mix(std::uint64_t& digest, double value) {
    digest = (digest ^ std::bit_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15U;
    digest ^= digest >> 29U;
}

void audit_tick(const PenetrationOracle& oracle, const WalkSettings& settings, const MoverState& state,
                const MoveTrace& trace, WalkAudit& audit) {
    audit.finite = audit.finite && state.foot.allFinite() && std::isfinite(state.vertical_speed);
    if (!audit.finite) {
        return;
    }
    const Penetration now = oracle.worst_penetration(state.foot, settings.radius, settings.height);
    if (now.depth > audit.deepest.depth) {
        audit.deepest = now;
    }
    audit.ticks_inside += now.depth > WalkAudit::kAllowed ? 1 : 0;
    for (std::size_t i = 1; i < trace.path.size(); ++i) {
        const Vec3& from = trace.path[i - 1];
        const Vec3& to = trace.path[i];
        audit.crossings += oracle.crossed(from, to, settings.radius, settings.height) ? 1 : 0;
        audit.distance += (to - from).norm();
    }
    for (const double value : {state.foot.x(), state.foot.y(), state.foot.z(), state.vertical_speed}) {
        mix(audit.digest, value);
    }
}

}  // namespace

WalkAudit audit_random_walk(const PenetrationOracle& oracle, const MoveBody& move,
                            const WalkSettings& settings) {
    Dice dice(settings.seed);
    WalkAudit audit;
    MoverState state;
    state.foot = settings.start;
    MoveTrace trace;
    const double seconds = 1.0 / settings.ticks_per_second;
    Vec3 velocity = Vec3::Zero();
    int until_turn = 0;
    for (int tick = 0; tick < settings.ticks && audit.finite; ++tick) {
        if (until_turn-- <= 0) {
            const double heading = dice.between(-std::numbers::pi, std::numbers::pi);
            const double speed = dice.between(0.2, 1.0) * settings.fastest;
            velocity = speed * Vec3(std::cos(heading), 0, std::sin(heading));
            until_turn = static_cast<int>(dice.between(20.0, 150.0));
        }
        move(state, velocity * seconds, seconds, trace);
        audit_tick(oracle, settings, state, trace, audit);
    }
    audit.end = state;
    return audit;
}

}  // namespace campuswalk::support
