#include "engine/walkspace/report/crowded_places.h"

#include <cmath>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// A lawn of 20 m with a hedge of 2 m in its middle that consists of `rows` x `rows` leaves.
scene::Campus garden(int rows) {
    scene::Campus campus = empty_campus();
    add_box(campus, "lawn", {-10, -0.2, -10}, {10, 0, 10});
    collision::TriangleMesh leaves;
    for (int i = 0; i < rows; ++i) {
        for (int k = 0; k < rows; ++k) {
            const Vec3 at(2.0 * i / rows - 1.0, 0.5, 2.0 * k / rows - 1.0);
            const auto first = static_cast<std::uint32_t>(leaves.positions.size());
            for (const Vec3& beside : {Vec3(0, 0, 0), Vec3(0, 0, 0.01), Vec3(0.01, 0, 0)}) {
                leaves.positions.push_back((at + beside).cast<float>());
            }
            leaves.triangles.push_back({first, first + 1, first + 2});
        }
    }
    add_object(campus, "hedge", std::make_shared<const collision::MeshCollider>(std::move(leaves)),
               Vec3::Zero());
    return campus;
}

TEST(CrowdedPlaces, AreWhereMostTrianglesAre) {
    const scene::Campus campus = garden(500);
    const CrowdedPlaces crowded(campus.world, explore_settings(campus, AvatarProfile(), 60));
    ASSERT_TRUE(crowded.limit());
    EXPECT_GE(*crowded.limit(), 1000.0);
    EXPECT_TRUE(crowded.contains({0, 0, 0}));
    EXPECT_TRUE(crowded.contains({1.5, 0, 0}));
    EXPECT_FALSE(crowded.contains({8, 0, 8}));
}

TEST(CrowdedPlaces, AreNoneWhereWalkingTakesLittle) {
    const scene::Campus campus = garden(100);
    const CrowdedPlaces crowded(campus.world, explore_settings(campus, AvatarProfile(), 60));
    EXPECT_FALSE(crowded.limit());
    EXPECT_FALSE(crowded.contains({0, 0, 0}));
}

}  // namespace
}  // namespace campuswalk::engine
