#include "engine/walkspace/report/triangle_density.h"

#include <gtest/gtest.h>

#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

TEST(TriangleDensity, CountsSmallTrianglesNearTheBody) {
    collision::TriangleMesh mesh;
    support::add_box(mesh, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4});
    support::add_box(mesh, {0.2, 3.2, 0.2}, {0.4, 3.4, 0.4});
    const scene::Campus campus = campus_of(mesh);
    const TriangleDensity density(campus.world);
    EXPECT_EQ(density.around({0.5, 0.0, 0.5}), 24.0);  // the second one is in the cells above
    EXPECT_EQ(density.around({-0.5, 3.0, 1.5}), 12.0);
    EXPECT_EQ(density.around({0.5, 4.5, 0.5}), 0.0);
    EXPECT_EQ(density.around({2.5, 0.0, 0.5}), 0.0);
}

}  // namespace
}  // namespace campuswalk::engine
