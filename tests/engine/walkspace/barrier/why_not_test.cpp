#include "engine/walkspace/barrier/why_not.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/script/avatar_body.h"
#include "tests/engine/walkspace/barrier/barrier_course.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

ExploreSettings adult() {
    ExploreSettings settings;
    settings.strides.body = mover_settings(AvatarProfile());
    return settings;
}

/// What keeps an adult from the goal of a case, as `explore` asks: from where it can get to.
std::optional<Barrier> barrier_of(const BarrierCase& built) {
    const WorkerWorlds worlds(*built.world, 1, {});
    ExploreSettings settings = adult();
    settings.starts = {built.start};
    settings.keep_rim = true;
    const WalkSpace reached = explore(worlds, settings);
    PassageQuery query;
    for (const WalkTile& tile : reached.tiles) {
        for (const WalkTile::Keyframe& rim : tile.rim) {
            if ((rim.at.foot - built.goal).norm() < 5.2) {
                query.from.push_back(rim.at);
            }
        }
    }
    const GridCell goal = reached.grid.cell_at(built.goal);
    query.is_beyond = [&](const GridCell& cell, double y) {
        return std::abs(cell.x - goal.x) <= 1 && std::abs(cell.z - goal.z) <= 1 &&
               std::abs(y - built.goal.y()) <= 0.15;
    };
    query.within.extend(built.start);
    query.within.extend(built.goal);
    query.within = query.within.grown(5.0);
    query.known = {&reached};
    return barrier_in(why_not(worlds, settings, query));
}

const Barrier* part_of(const Barrier& barrier, ReasonKind kind) {
    for (const Barrier& part : barrier.parts) {
        if (part.kind == kind) {
            return &part;
        }
    }
    return nullptr;
}

TEST(WhyNot, NamesAndMeasuresEachOf200BuiltBarriers) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    std::size_t number = 0;
    for (const BarrierCase& built : barrier_course()) {
        SCOPED_TRACE("case " + std::to_string(number++) + ", " + built.name + " " +
                     std::to_string(built.measured));
        const auto barrier = barrier_of(built);
        ASSERT_TRUE(barrier);
        const bool gate_with_opening = built.opening && barrier->kind == ReasonKind::opening;
        if (!gate_with_opening) {
            EXPECT_EQ(barrier->kind, built.kind);
        }
        if (built.kind == ReasonKind::slope) {
            EXPECT_NEAR(barrier->measured, built.measured, 0.5 * kDegree);
        } else if (built.kind != ReasonKind::object) {
            EXPECT_NEAR(barrier->measured, built.measured, 0.01);
        }
        if (built.object && !gate_with_opening) {
            EXPECT_EQ(barrier->object, built.object);
        }
        if (built.opening) {
            const Barrier* opening = gate_with_opening ? &*barrier : part_of(*barrier, ReasonKind::opening);
            ASSERT_NE(opening, nullptr);
            EXPECT_NEAR(opening->measured, *built.opening, 0.01);
            const Barrier* object = gate_with_opening ? part_of(*barrier, ReasonKind::object) : &*barrier;
            ASSERT_NE(object, nullptr);
            EXPECT_EQ(object->object, built.object);
        }
    }
}

/// Without any of a pen's four panels there would be a way; the one on the way is wanted, though others are a
/// little smaller.
TEST(WhyNot, NamesThePanelOnThePath) {
    BarrierCase pen;
    pen.world = std::make_unique<collision::World>(std::make_unique<collision::LinearBroadPhase>());
    const auto box = [&](const Vec3& min, const Vec3& max) {
        return pen.world->add(
            {collision::Box{0.5 * (max - min)}, {collision::Mat3::Identity(), 0.5 * (min + max)}});
    };
    box({-8, -0.5, -8}, {8, 0, 8});
    for (const double side : {-1.0, 1.0}) {
        box({-0.95, 0, side - 0.05}, {0.95, 1.9, side + 0.05});
    }
    box({0.95, 0, -1}, {1.05, 1.9, 1});
    const collision::ObjectId front = box({-1.05, 0, -1}, {-0.95, 2.1, 1});
    pen.start = Vec3(-4, 0, 0);
    const auto barrier = barrier_of(pen);
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->kind, ReasonKind::object);
    EXPECT_EQ(barrier->object, front);
    EXPECT_NEAR(barrier->at.x(), -1.05, 0.01);
}

}  // namespace
}  // namespace campuswalk::engine
