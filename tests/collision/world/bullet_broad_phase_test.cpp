#include "collision/world/bullet_broad_phase.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

/// The same boxes in Bullet's tree and in the linear broad phase.
class BulletAndLinear {
public:
    BulletAndLinear(support::Dice& dice, const Vec3& about, std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Aabb box = random_box(dice, about, dice.chance(0.1) ? 10.0 : 0.5);
            bullet_->insert(ObjectId{i}, box);
            linear_.insert(ObjectId{i}, box);
            boxes_.push_back(box);
        }
    }

    static Aabb random_box(support::Dice& dice, const Vec3& about, double size) {
        const Vec3 center = about + dice.in_cube(30.0);
        const Vec3 half = dice.in_cube(size).cwiseAbs();
        return {center - half, center + half};
    }

    /// Nothing is missing, nothing is there twice, and extra boxes come only from rounding to float32.
    void expect_agreement(const Aabb& query, double rounding) const {
        const std::vector<ObjectId> found = sorted_overlaps(*bullet_, query);
        const std::vector<ObjectId> needed = sorted_overlaps(linear_, query);
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
        EXPECT_TRUE(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
        for (const ObjectId id : found) {
            EXPECT_TRUE(boxes_[index_of(id)].grown(rounding).overlaps(query.grown(rounding)));
        }
    }

    void expect_no_crossing_missed(const Vec3& from, const Vec3& to) const {
        std::vector<ObjectId> found;
        bullet_->crossing(from, to, found);
        std::vector<ObjectId> needed;
        linear_.crossing(from, to, needed);
        std::sort(found.begin(), found.end());
        EXPECT_TRUE(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
    }

    const Aabb& box(std::size_t i) const { return boxes_[i]; }

private:
    static std::vector<ObjectId> sorted_overlaps(const BroadPhase& phase, const Aabb& query) {
        std::vector<ObjectId> found;
        phase.overlapping(query, found);
        std::sort(found.begin(), found.end());
        return found;
    }

    std::unique_ptr<BroadPhase> bullet_ = make_bullet_broad_phase();
    LinearBroadPhase linear_;
    std::vector<Aabb> boxes_;
};

TEST(BulletBroadPhase, FindsWhatALinearSearchFinds) {
    support::Dice dice(9);
    const BulletAndLinear both(dice, Vec3::Zero(), 500);
    for (int i = 0; i < 1000; ++i) {
        both.expect_agreement(BulletAndLinear::random_box(dice, Vec3::Zero(), 3.0), 1e-5);
        both.expect_no_crossing_missed(dice.in_cube(35.0), dice.in_cube(35.0));
    }
}

/// Where float32 steps are 3 cm, rounding must go outward.
TEST(BulletBroadPhase, MissesNothingFarFromTheOrigin) {
    support::Dice dice(10);
    const Vec3 far(450e3, 12.0, -450e3);
    const BulletAndLinear both(dice, far, 300);
    for (int i = 0; i < 1000; ++i) {
        both.expect_agreement(BulletAndLinear::random_box(dice, far, 3.0), 0.07);
        both.expect_no_crossing_missed(far + dice.in_cube(35.0), far + dice.in_cube(35.0));
    }
}

TEST(BulletBroadPhase, FindsBoxesThatOnlyTouch) {
    support::Dice dice(11);
    const BulletAndLinear both(dice, Vec3::Zero(), 100);
    for (std::size_t i = 0; i < 100; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            Aabb beside = both.box(i);
            beside.min[axis] = both.box(i).max[axis];
            beside.max[axis] = beside.min[axis] + 1.0;
            both.expect_agreement(beside, 1e-5);
        }
    }
}

TEST(BulletBroadPhase, FindsNothingWhenEmpty) {
    const auto phase = make_bullet_broad_phase();
    std::vector<ObjectId> found;
    phase->overlapping({Vec3(-1, -1, -1), Vec3(1, 1, 1)}, found);
    phase->crossing({-1, -1, -1}, {1, 1, 1}, found);
    EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace campuswalk::collision
