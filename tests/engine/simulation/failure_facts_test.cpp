// What a failure's message says about obstacles, it has as facts, too, up to the results in JSON.

#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/events/decimals.h"
#include "engine/report/result_json.h"
#include "engine/walkspace/barrier/barrier_reason.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/barrier/barrier_course.h"

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;

scene::Campus campus_of(BarrierCase& built) {
    scene::Campus campus{{}, {}, {}, std::move(*built.world)};
    for (std::size_t i = 0; i < campus.world.size(); ++i) {
        campus.objects.push_back({"object-" + std::to_string(i), {}, {}});
    }
    return campus;
}

Target target_at(const collision::Vec3& point) {
    Target target;
    target.label = "goal";
    target.point = point;
    target.has_height = true;
    return target;
}

/// The walk's only failure, read back from its result's line.
Failure failure_of(const scene::Campus& campus, Step step, const collision::Vec3& start) {
    const RecordedRun played = run(campus, walk_of({spawn_at(start), std::move(step)}));
    WalkResult result;
    result.failures = played.summary.failures;
    const WalkResult back = result_from_json_line(to_json_line(result));
    EXPECT_EQ(back.failures.size(), 1U);
    return back.failures.empty() ? Failure() : back.failures.front();
}

/// The reason, or the first of its parts, that was measured.
const Reason* measured_in(const Reason& reason) {
    if (reason.measured) {
        return &reason;
    }
    for (const Reason& part : reason.parts) {
        if (const Reason* found = measured_in(part)) {
            return found;
        }
    }
    return nullptr;
}

/// Whether the barrier says what the course has built there.
void expect_facts(const BarrierCase& built, const Failure& failure) {
    ASSERT_TRUE(failure.reason) << failure.message;
    EXPECT_THAT(failure.message, HasSubstr(text_of(*failure.reason)));
    if (built.kind == ReasonKind::object) {
        const std::string id = "object-" + std::to_string(index_of(*built.object));
        const bool named = failure.reason->object == id ||
                           (!failure.reason->parts.empty() && failure.reason->parts.front().object == id);
        EXPECT_TRUE(named) << failure.message;
        return;
    }
    const Reason* barrier = measured_in(*failure.reason);
    ASSERT_NE(barrier, nullptr) << failure.message;
    const bool is_slope = built.kind == ReasonKind::slope;
    EXPECT_EQ(name_of(barrier->kind), name_of(built.kind));
    EXPECT_NEAR(*barrier->measured, is_slope ? degrees(built.measured) : built.measured,
                is_slope ? 0.5 : 0.01);
}

TEST(FailureFacts, OfEachOf200BuiltBarriersAreThoseOfItsMessage) {
    for (BarrierCase& built : barrier_course()) {
        SCOPED_TRACE(built.name + " " + std::to_string(built.measured));
        const scene::Campus campus = campus_of(built);
        GoToStep step;
        step.target = target_at(built.goal);
        const Failure failure = failure_of(campus, step, built.start);
        EXPECT_EQ(failure.code, "unreachable") << failure.message;
        expect_facts(built, failure);
    }
}

TEST(FailureFacts, OfAWalkToNameTheObjectAndTheRoute) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-20, 0, -4}, {6, 6, -3.8});
    const Failure failure = failure_of(campus, walk_to(0, -10), {0, 0, 0});
    ASSERT_TRUE(failure.reason) << failure.message;
    EXPECT_EQ(failure.reason->object, "wall");
    EXPECT_EQ(failure.object, "wall");
    ASSERT_TRUE(failure.route);
    EXPECT_EQ(failure.route->to, "goal");
    EXPECT_NEAR(failure.route->length, 15.0, 1.0);
    EXPECT_THAT(failure.message, HasSubstr("; from there " + text_of(*failure.route)));
}

TEST(FailureFacts, OfAFallNameTheEdge) {
    scene::Campus campus = empty_campus();
    add_box(campus, "deck", {-2, -0.5, -2}, {2, 0, 2});
    const Failure failure = failure_of(campus, walk_to(0, -10), {0, 0, 0});
    EXPECT_EQ(failure.code, "fell");
    ASSERT_TRUE(failure.reason) << failure.message;
    EXPECT_EQ(failure.reason->kind, ReasonKind::edge);
    EXPECT_EQ(failure.reason->object, "deck");
    EXPECT_NEAR(failure.reason->at->z(), -2.0, 0.05);
}

TEST(FailureFacts, OfAnExpectationAreTheLastObstacle) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-20, 0, -4}, {20, 6, -3.8});
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to_or_proceed(0, -10)});
    walk.expectations = {PlainExpectation(expect_reaches(target_at({0, 0, -10}), 0.5))};
    const RecordedRun played = run(campus, walk);
    ASSERT_EQ(played.summary.failures.size(), 1U);
    const Failure& failure = played.summary.failures[0];
    ASSERT_TRUE(failure.reason);
    EXPECT_EQ(failure.reason->object, "wall");
    EXPECT_EQ(failure.object, "wall");
}

}  // namespace
}  // namespace campuswalk::engine
