#include "collision/world/broad_phase.h"

#include <gtest/gtest.h>

#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

Aabb random_box(support::Dice& dice) {
    const Vec3 center = dice.in_cube(10.0);
    const Vec3 half = dice.in_cube(dice.chance(0.2) ? 5.0 : 0.5).cwiseAbs();
    return {center - half, center + half};
}

TEST(LinearBroadPhase, FindsTheOverlappingBoxes) {
    LinearBroadPhase phase;
    phase.insert(ObjectId{7}, {Vec3(0, 0, 0), Vec3(1, 1, 1)});
    phase.insert(ObjectId{3}, {Vec3(2, 0, 0), Vec3(3, 1, 1)});
    std::vector<ObjectId> found{ObjectId{99}};
    phase.overlapping({Vec3(0.5, 0.5, 0.5), Vec3(1.5, 0.6, 0.6)}, found);
    EXPECT_EQ(found, (std::vector{ObjectId{99}, ObjectId{7}})) << "results are appended";
    found.clear();
    phase.overlapping({Vec3(1, 1, 1), Vec3(2, 2, 2)}, found);
    EXPECT_EQ(found, (std::vector{ObjectId{7}, ObjectId{3}})) << "touching at a vertex counts";
    found.clear();
    phase.overlapping({Vec3(0, 1.01, 0), Vec3(3, 2, 1)}, found);
    EXPECT_TRUE(found.empty());
}

TEST(LinearBroadPhase, FindsTheBoxesThatASegmentCrosses) {
    support::Dice dice(8);
    LinearBroadPhase phase;
    std::vector<Aabb> boxes;
    for (std::uint32_t i = 0; i < 200; ++i) {
        boxes.push_back(random_box(dice));
        phase.insert(ObjectId{i}, boxes.back());
    }
    int hits = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const support::Line line{dice.in_cube(12.0), dice.in_cube(12.0)};
        std::vector<ObjectId> found;
        phase.crossing(line.from, line.to, found);
        std::vector<bool> is_found(boxes.size());
        for (const ObjectId id : found) {
            is_found[index_of(id)] = true;
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Vec3 center = 0.5 * (boxes[i].min + boxes[i].max);
            const Vec3 half = 0.5 * (boxes[i].max - boxes[i].min);
            const double nearest = support::least_on_unit_interval(
                [&](double t) { return support::signed_distance_to_box(line.at(t) - center, half); });
            if (nearest < -1e-9) {
                EXPECT_TRUE(is_found[i]) << trial << ' ' << i;
            } else if (nearest > 1e-9) {
                EXPECT_FALSE(is_found[i]) << trial << ' ' << i;
            }
        }
        hits += static_cast<int>(found.size());
    }
    EXPECT_GT(hits, 200);
}

}  // namespace
}  // namespace campuswalk::collision
