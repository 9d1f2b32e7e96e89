// Narrow gaps, which a grid of cells could miss: sliding finds them.

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/angles.h"
#include "tests/support/course/walls.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Pose;
using collision::TriangleMesh;
using collision::Vec3;

/// A floor of 5 m by 5 m, cut in two by a wall with a gap, turned and shifted against the grid of cells.
bool passes(double gap, double thickness, double degrees, const Vec3& offset) {
    TriangleMesh mesh;
    support::add_floor(mesh, 2.5);
    support::add_doorway(mesh, 0.0, thickness, gap, 3.0);
    Pose pose;
    pose.rotation = support::turn(Vec3::UnitY(), support::radians(degrees));
    pose.translation = offset;
    scene::Campus campus = empty_campus();
    support::add_object(campus.world, std::move(mesh), collision::Detection::solid, pose);
    campus.objects.resize(1);
    const WalkSpace space = explored(campus, pose * Vec3(-1.5, 0, 0.7));
    return reaches(space, pose * Vec3(1.5, 0, -0.7));
}

TEST(Explore, PassesGapsThatAreJustWideEnough) {
    int tried = 0;
    for (const double thickness : {0.0, 0.2}) {
        for (const double degrees : {0.0, 7.0, 22.5, 33.0, 45.0, 61.0, 90.0}) {
            for (const double shift : {0.0, 0.06, 0.125, 0.19}) {
                const Vec3 offset(shift, 0, 0.13 - shift);
                const std::string where = "thickness " + std::to_string(thickness) + ", " +
                                          std::to_string(degrees) + " degrees, shifted by " +
                                          std::to_string(shift);
                EXPECT_TRUE(passes(0.601, thickness, degrees, offset)) << where;
                EXPECT_FALSE(passes(0.599, thickness, degrees, offset)) << where;
                ++tried;
            }
        }
    }
    EXPECT_EQ(tried, 56);
}

}  // namespace
}  // namespace campuswalk::engine
