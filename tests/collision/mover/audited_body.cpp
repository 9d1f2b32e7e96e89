#include "tests/collision/mover/audited_body.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/audited_walk.h"

namespace campuswalk::collision {

AuditedBody::AuditedBody(const World& world, const MoverSettings& settings, const QueryFilter& filter)
    : settings_(settings), oracle_(world, filter), mover_(world, settings, filter) {}

void AuditedBody::stand(const Vec3& foot, double search) {
    mover_.place(state_, foot, search, cache_);
    ticks_in_air_ = 0;
    trace_ = {};
    audit();
}

void AuditedBody::tick(const Vec3& velocity) {
    const double seconds = 1.0 / ticks_per_second;
    const Vec3 before = state_.foot;
    mover_.move(state_, velocity * seconds, seconds, cache_, trace_);
    ticks_in_air_ += state_.grounded ? 0 : 1;
    audit();
    ASSERT_EQ(trace_.path.front(), before);
    ASSERT_EQ(trace_.path.back(), state_.foot);
}

void AuditedBody::walk(const Vec3& velocity, double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds * ticks_per_second));
    for (int i = 0; i < ticks && !::testing::Test::HasFatalFailure(); ++i) {
        tick(velocity);
    }
}

void AuditedBody::fall_down() {
    const auto limit = static_cast<int>(10.0 * ticks_per_second);
    for (int i = 0; i < limit && !state_.grounded; ++i) {
        tick(Vec3::Zero());
    }
    ASSERT_TRUE(state_.grounded) << "still falling at " << state_.foot.transpose();
}

bool AuditedBody::touches(ObjectId id) const {
    return std::any_of(trace_.touching.begin(), trace_.touching.end(),
                       [&](const Touch& touch) { return touch.object == id; });
}

void AuditedBody::audit() const {
    ASSERT_TRUE(state_.foot.allFinite());
    const auto now = oracle_.worst_penetration(state_.foot, settings_.radius, settings_.height);
    ASSERT_LE(now.depth, support::WalkAudit::kAllowed)
        << "inside object " << now.object.value_or(999) << " at " << state_.foot.transpose();
    for (std::size_t i = 1; i < trace_.path.size(); ++i) {
        ASSERT_FALSE(oracle_.crossed(trace_.path[i - 1], trace_.path[i], settings_.radius, settings_.height))
            << "passed through something while moving to " << state_.foot.transpose();
    }
}

}  // namespace campuswalk::collision
