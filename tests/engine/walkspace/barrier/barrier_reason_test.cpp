#include "engine/walkspace/barrier/barrier_reason.h"

#include <memory>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision/world/broad_phase.h"

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;

std::string text_of(ReasonKind kind, double measured, double allowed) {
    const scene::Campus campus{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
    Barrier barrier;
    barrier.kind = kind;
    barrier.measured = measured;
    barrier.allowed = allowed;
    return text_of(reason_of(campus, barrier));
}

TEST(BarrierReason, NumbersHaveSoManyDecimalsThatTheyDiffer) {
    EXPECT_EQ(text_of(ReasonKind::riser, 0.17, 0.1),
              "riser of 0.17 m at 0.00, 0.00, 0.00; the avatar steps 0.10 m");
    EXPECT_EQ(text_of(ReasonKind::riser, 0.17, 0.165),
              "riser of 0.170 m at 0.00, 0.00, 0.00; the avatar steps 0.165 m");
    EXPECT_THAT(text_of(ReasonKind::opening, 0.5996, 0.6),
                HasSubstr("is 0.5996 m wide, the body needs 0.6000 m"));
    EXPECT_THAT(text_of(ReasonKind::headroom, 1.798, 1.8), HasSubstr("headroom of 1.798 m"));
    constexpr double kDegree = std::numbers::pi / 180.0;
    EXPECT_THAT(text_of(ReasonKind::slope, 50.04 * kDegree, 50.0 * kDegree),
                HasSubstr("slope of 50.04 degrees at 0.00, 0.00, 0.00; the avatar walks up 50.00"));
}

TEST(BarrierReason, NumbersThatAreEqualToATenthOfAMillimetreStayReadable) {
    EXPECT_THAT(text_of(ReasonKind::riser, 0.30000001, 0.3), HasSubstr("riser of 0.3000 m"));
}

Barrier barrier_at(ReasonKind kind, double measured, double allowed, double x) {
    Barrier barrier;
    barrier.kind = kind;
    barrier.measured = measured;
    barrier.allowed = allowed;
    barrier.at = {x, 0, 0};
    return barrier;
}

TEST(BarrierReason, OfASequenceWhatTheBodyManagesIsSaidOnceForEachKind) {
    const scene::Campus campus{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
    Barrier all;
    all.kind = ReasonKind::sequence;
    all.parts = {barrier_at(ReasonKind::riser, 0.45, 0.3, 1), barrier_at(ReasonKind::riser, 0.5, 0.3, 2)};
    EXPECT_EQ(text_of(reason_of(campus, all)),
              "riser of 0.45 m at 1.00, 0.00, 0.00, then riser of 0.50 m at 2.00, 0.00, 0.00; "
              "the avatar steps 0.30 m");
    all.parts.push_back(barrier_at(ReasonKind::opening, 0.55, 0.6, 3));
    EXPECT_THAT(text_of(reason_of(campus, all)),
                HasSubstr("the avatar steps 0.30 m; then the opening at 3.00, 0.00, 0.00 is 0.55 m wide"));
}

}  // namespace
}  // namespace campuswalk::engine
