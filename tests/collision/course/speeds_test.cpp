#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/audited_walk.h"
#include "tests/support/effort.h"
#include "tests/support/village.h"

/// The course's speeds: from a stroll to 100 m/s, at 30 to 240 ticks per second, among everything in a
/// village, no tick ends inside anything or passes through it.
namespace campuswalk::collision::course {
namespace {

class CourseSpeeds : public ::testing::TestWithParam<double> {};

TEST_P(CourseSpeeds, NothingIsEnteredOrPassedThrough) {
    const auto world = support::make_village();
    const support::PenetrationOracle oracle(*world);
    const CapsuleMover mover(*world, {}, {});
    MoverCache cache;
    const auto move = [&](MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
        mover.move(state, desired, seconds, cache, trace);
    };
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        SCOPED_TRACE(testing::Message() << GetParam() << " m/s, " << rate << " Hz");
        support::WalkSettings settings;
        settings.start = {0, 1, 0};
        settings.seed = static_cast<std::uint32_t>(rate);
        settings.fastest = GetParam();
        settings.ticks_per_second = rate;
        settings.ticks = support::repeats(400);
        const support::WalkAudit audit = support::audit_random_walk(oracle, move, settings);
        EXPECT_TRUE(audit.clean()) << audit.ticks_inside << " ticks inside, " << audit.crossings
                                   << " crossings, deepest " << audit.deepest.depth << " m in object "
                                   << audit.deepest.object.value_or(999);
        EXPECT_GT(audit.distance, 0.5 * settings.ticks / 400.0);
    }
}

INSTANTIATE_TEST_SUITE_P(MetresPerSecond, CourseSpeeds, ::testing::Values(0.5, 1.4, 5.0, 20.0, 50.0, 100.0),
                         [](const auto& test) {
                             return std::to_string(static_cast<int>(10.0 * test.param)) + "_tenths";
                         });

}  // namespace
}  // namespace campuswalk::collision::course
