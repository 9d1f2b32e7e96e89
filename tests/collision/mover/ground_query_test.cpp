#include "collision/mover/ground_query.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/broad_phase.h"
#include "tests/support/effort.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

/// As much as furniture in detail: hundreds of triangles within the body's reach.
std::unique_ptr<World> make_thicket(Dice& dice) {
    auto world = std::make_unique<World>(std::make_unique<LinearBroadPhase>());
    TriangleMesh mesh;
    for (int i = 0; i < 400; ++i) {
        const Vec3 at(dice.between(-0.7, 0.7), dice.between(-0.2, 1.0), dice.between(-0.7, 0.7));
        const double size = dice.chance(0.1) ? 1.0 : 0.1;
        for (int k = 0; k < 3; ++k) {
            const Vec3 vertex(dice.between(-size, size), dice.between(-size, size),
                              dice.between(-size, size));
            mesh.positions.push_back((at + vertex).cast<float>());
        }
        const auto first = static_cast<std::uint32_t>(3 * i);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    Object object;
    object.shape = std::make_shared<const MeshCollider>(std::move(mesh));
    world->add(std::move(object));
    Object ball;
    ball.shape = Sphere{0.2};
    ball.X_world_shape.translation = Vec3(0.3, dice.between(0.0, 0.5), 0.1);
    world->add(std::move(ball));
    return world;
}

/// The quick choice of candidates drops none that matters: the answers are the same to the last bit.
TEST(GroundQuery, BesideABodyFindsWhatASearchOfAllPiecesFinds) {
    const MoverSettings body;
    int carried = 0;
    int blocked = 0;
    std::size_t most_near = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(60)); ++seed) {
        Dice dice(seed);
        const auto world = make_thicket(dice);
        ContactCache contacts;
        contacts.prepare(*world, body, {});
        MoveBuffers buffers;
        MoveContext context{body, body.steepest_rise(), contacts, buffers, {}};
        for (int i = 0; i < 5; ++i) {
            const Vec3 foot(dice.between(-0.3, 0.3), dice.between(-0.1, 0.3), dice.between(-0.3, 0.3));
            const Support stand{foot, foot.y() + (dice.chance(0.5) ? 0.0 : dice.between(0.0, 0.1))};
            const double up = stand.base + body.step_height + kHeightSlack - foot.y();
            contacts.cover({foot - Vec3::Constant(1.0), foot + Vec3(1.0, 3.0, 1.0)});
            context.near = contacts.survey(foot, kProbeDistance, up, up, body.skin + kListed);
            most_near = std::max(most_near, context.near.size());
            buffers.ground.foot.reset();
            buffers.ground.highest.reset();
            buffers.floor_end.reset();
            for (int k = 0; k < 40; ++k) {
                const double angle = dice.between(0.0, 6.3);
                const double aside = dice.between(0.0, kProbeDistance);
                const double x = foot.x() + aside * std::cos(angle);
                const double z = foot.z() + aside * std::sin(angle);
                const Ground found = find_ground_beside(context, x, z, stand);
                const auto highest = buffers.ground.highest;
                buffers.ground.highest.reset();
                buffers.floor_end.reset();
                const Ground all = find_ground(context, x, z, stand, up, 2.0 * kRestGap);
                buffers.ground.highest = highest;
                ASSERT_EQ(found.found, all.found) << "seed " << seed << ", " << i << ", " << k;
                ASSERT_EQ(found.carries, all.carries) << "seed " << seed << ", " << i << ", " << k;
                ASSERT_EQ(found.foot_y, all.foot_y) << "seed " << seed << ", " << i << ", " << k;
                ASSERT_EQ(found.support_y, all.support_y) << "seed " << seed << ", " << i << ", " << k;
                carried += found.carries ? 1 : 0;
                blocked += found.found && !found.carries ? 1 : 0;
            }
        }
    }
    EXPECT_GT(most_near, 100U);
    EXPECT_GT(carried, support::repeats(1000));
    EXPECT_GT(blocked, support::repeats(200));
}

}  // namespace
}  // namespace campuswalk::collision
