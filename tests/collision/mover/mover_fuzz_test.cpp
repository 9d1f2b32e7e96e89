#include <memory>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/support/audited_walk.h"
#include "tests/support/effort.h"
#include "tests/support/penetration_oracle.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::WalkAudit;

struct Place {
    const char* name = "";
    std::unique_ptr<World> (*make)(Dice&) = nullptr;
    double half = 0.0;
    double fastest = 0.0;  ///< metres per second; at 40 one tick's motion is longer than the body is wide
    int walks = 0;
};

WalkAudit walk_through(const Place& place, std::uint32_t seed, int ticks) {
    Dice dice(seed);
    const auto world = place.make(dice);
    const support::PenetrationOracle oracle(*world);
    const MoverSettings body;
    const CapsuleMover mover(*world, body, {});
    MoverCache cache;
    support::WalkSettings settings;
    settings.start = support::random_free_place(*world, dice, place.half);
    settings.seed = seed;
    settings.fastest = place.fastest;
    settings.ticks = ticks;
    const auto move = [&](MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
        mover.move(state, desired, seconds, cache, trace);
    };
    return support::audit_random_walk(oracle, move, settings);
}

class MoverFuzz : public ::testing::TestWithParam<Place> {};

TEST_P(MoverFuzz, NeverEndsATickInsideAnything) {
    const auto walks = static_cast<std::uint32_t>(support::repeats(GetParam().walks));
    double walked = 0.0;
    for (std::uint32_t seed = 0; seed < walks; ++seed) {
        const WalkAudit audit = walk_through(GetParam(), seed, 500);
        EXPECT_TRUE(audit.clean()) << "seed " << seed << ": " << audit.ticks_inside << " ticks inside, "
                                   << audit.crossings << " crossings, deepest " << audit.deepest.depth
                                   << " m in object " << audit.deepest.object.value_or(999);
        walked += audit.distance;
    }
    EXPECT_GT(walked / walks, 1.5) << "the bodies are not stuck where they start";
}

TEST_P(MoverFuzz, IsBitIdenticalWhenRepeated) {
    for (std::uint32_t seed = 100; seed < 102; ++seed) {
        EXPECT_EQ(walk_through(GetParam(), seed, 200).digest, walk_through(GetParam(), seed, 200).digest);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Places, MoverFuzz,
    ::testing::Values(Place{"soup", support::make_soup, support::kSoupHalf, 2.0, 30},
                      Place{"fast_soup", support::make_soup, support::kSoupHalf, 40.0, 12},
                      Place{"village", support::make_random_village, support::kRandomVillageHalf, 3.0, 30},
                      Place{"fast_village", support::make_random_village, support::kRandomVillageHalf, 40.0,
                            12}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace campuswalk::collision
