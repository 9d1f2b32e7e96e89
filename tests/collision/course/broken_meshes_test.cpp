#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/audited_walk.h"
#include "tests/support/course/profile.h"
#include "tests/support/course/walls.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"

/// The course's meshes as they occur in practice: flipped, doubled, split by slivers and T-junctions, in any
/// order, far from the origin. No damage moves the surface, so the walk must be the same.
namespace campuswalk::collision::course {
namespace {

using support::Dice;

/// A yard: floor, a flight up to a terrace, a ramp down, a wall across, a kerb, a corner.
TriangleMesh yard() {
    TriangleMesh mesh;
    support::add_floor(mesh, 12.0, 0.0, 1.5);
    support::add_stairs(mesh, 2.0, -2.0, 4.0, 0.17, 0.28, 6);
    support::add_quad(mesh, {4.4, 1.02, 2}, {7.4, 0, 2}, {7.4, 0, -2}, {4.4, 1.02, -2});
    support::add_doorway(mesh, -4.0, 0.2, 0.9, 2.1);
    support::add_box(mesh, {-3, 0, 5}, {6, 0.12, 8});
    support::add_box(mesh, {9, 0, -10}, {9.2, 2.5, 10});
    support::add_box(mesh, {-3, 0, -5}, {9, 2.5, -4.8});
    return mesh;
}

void shuffle(TriangleMesh& mesh, Dice& dice) {
    for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
        std::swap(mesh.triangles[i - 1],
                  mesh.triangles[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    }
}

void flip_some(TriangleMesh& mesh, Dice& dice) {
    for (auto& triangle : mesh.triangles) {
        if (dice.chance(0.5)) {
            std::swap(triangle[0], triangle[1]);
        }
    }
}

void double_some(TriangleMesh& mesh, Dice& dice) {
    const auto once = mesh.triangles;
    for (const auto& triangle : once) {
        if (dice.chance(0.5)) {
            mesh.triangles.push_back(triangle);
        }
        if (dice.chance(0.2)) {
            mesh.triangles.push_back({triangle[0], triangle[0], triangle[1]});  // without area
        }
    }
}

/// Cuts `share` of the triangles in two from their first vertex, at `part` of the opposite edge. The
/// neighbour across that edge keeps it whole: a T-junction, and with a small part a sliver. The new vertex is
/// rounded to float32, so the halves are up to a micrometre out of plane, and slivers noticeably turned.
void cut(TriangleMesh& mesh, Dice& dice, double share, double part) {
    const auto once = mesh.triangles;
    mesh.triangles.clear();
    for (const auto& t : once) {
        if (!dice.chance(share)) {
            mesh.triangles.push_back(t);
            continue;
        }
        const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(mesh.positions[t[1]] +
                                 static_cast<float>(part) * (mesh.positions[t[2]] - mesh.positions[t[1]]));
        mesh.triangles.push_back({t[0], t[1], middle});
        mesh.triangles.push_back({t[0], middle, t[2]});
    }
}

/// A heading for some seconds.
struct Leg {
    double degrees = 0.0;
    double seconds = 0.0;
};

/// Over the stairs and the ramp to the wall, along it into the corner; back over the kerb and to the door.
constexpr std::array kLegs = {Leg{0.0, 5.0},   Leg{60.0, 2.0},  Leg{30.0, 2.0}, Leg{170.0, 4.0},
                              Leg{250.0, 5.0}, Leg{190.0, 4.0}, Leg{100.0, 3.0}};

/// Where the yard is, and the tick rate.
struct Setting {
    Vec3 mesh_at = Vec3::Zero();
    Vec3 yard_in_mesh = Vec3::Zero();  ///< of the yard's origin
    double rate = 60.0;
};

/// Where the body is at the end of each leg, relative to the yard's origin.
std::vector<Vec3> walk_the_yard(const TriangleMesh& mesh, const Setting& setting = {}) {
    auto world = empty_world();
    support::add_object(*world, mesh, Detection::solid, {Mat3::Identity(), setting.mesh_at});
    AuditedBody body(*world);
    body.ticks_per_second = setting.rate;
    const Vec3 origin = setting.mesh_at + setting.yard_in_mesh;
    body.stand(origin + Vec3(0, 0.01, 0.2));
    std::vector<Vec3> ends;
    for (const Leg& leg : kLegs) {
        body.walk(kPace * towards(leg.degrees), leg.seconds);
        ends.push_back(body.foot() - origin);
    }
    return ends;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, (a[i] - b[i]).norm());
    }
    return worst;
}

struct Damage {
    const char* name = "";
    void (*inflict)(TriangleMesh& mesh, Dice& dice) = nullptr;
    double allowed = 0.0;  ///< metres; 0 if the walk must be bit-identical
};

void PrintTo(const Damage& damage, std::ostream* out) {
    *out << damage.name;
}

class CourseBrokenMeshes : public ::testing::TestWithParam<Damage> {};

TEST_P(CourseBrokenMeshes, AreWalkedLikeIntactOnes) {
    const auto whole = walk_the_yard(yard());
    ASSERT_GT(whole[0].x(), 5.0) << "the walk gets over the stairs";
    const auto turns = static_cast<std::uint32_t>(support::repeats(4));
    for (std::uint32_t seed = 0; seed < turns; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        TriangleMesh mesh = yard();
        GetParam().inflict(mesh, dice);
        EXPECT_LE(farthest(walk_the_yard(mesh), whole), GetParam().allowed);
    }
}

INSTANTIATE_TEST_SUITE_P(KindsOfDamage, CourseBrokenMeshes,
                         ::testing::Values(Damage{"shuffled", shuffle, 0.0},
                                           Damage{"doubled", double_some, 0.0},
                                           Damage{"flipped", flip_some, 1e-6},
                                           Damage{"t_junctions",
                                                  [](TriangleMesh& mesh, Dice& dice) {
                                                      for (int i = 0; i < 3; ++i) {
                                                          cut(mesh, dice, 0.5, dice.between(0.2, 0.8));
                                                      }
                                                  },
                                                  1e-3},
                                           Damage{"slivers",
                                                  [](TriangleMesh& mesh, Dice& dice) {
                                                      for (const double part : {1e-3, 1e-5, 0.999}) {
                                                          cut(mesh, dice, 0.5, part);
                                                      }
                                                  },
                                                  1e-3}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Five kilometres away a double still resolves 1e-12 m: the walk is the same.
TEST(CoursePlaces, FarFromTheOriginTheWalkIsTheSame) {
    const auto here = walk_the_yard(yard());
    EXPECT_LE(farthest(walk_the_yard(yard(), {.mesh_at = {5000, 300, -5000}}), here), 1e-6);
}

/// Vertices of float32 at 5 km are on a grid of half a millimetre; the walk is about the same on it.
TEST(CoursePlaces, VerticesFarFromTheirOriginHardlyChangeTheWalk) {
    const auto here = walk_the_yard(yard());
    TriangleMesh far = yard();
    const Eigen::Vector3f offset(5000, 0, -5000);
    for (auto& position : far.positions) {
        position += offset;
    }
    EXPECT_LE(farthest(walk_the_yard(far, {.yard_in_mesh = offset.cast<double>()}), here), 0.02);
}

/// The cache saves work and never changes a result.
TEST(CoursePlaces, AFreshCacheEveryTickWalksTheSame) {
    auto world = empty_world();
    support::add_object(*world, yard());
    const CapsuleMover mover(*world, {}, {});
    MoverCache cache;
    MoverState state;
    mover.place(state, {0, 0.01, 0.2}, 0.5, cache);
    MoveTrace trace;
    for (const Leg& leg : kLegs) {
        for (int i = 0; i < 60.0 * leg.seconds; ++i) {
            const Vec3 desired = kPace / 60.0 * towards(leg.degrees);
            MoverState other = state;
            MoverCache fresh;
            mover.move(other, desired, 1.0 / 60.0, fresh, trace);
            mover.move(state, desired, 1.0 / 60.0, cache, trace);
            ASSERT_EQ(other.foot, state.foot);
            ASSERT_EQ(other.vertical_speed, state.vertical_speed);
            ASSERT_EQ(other.grounded, state.grounded);
        }
    }
}

/// The walk depends on the time, not on the number of ticks.
TEST(CoursePlaces, TheTickRateDoesNotChangeTheWalk) {
    const auto usual = walk_the_yard(yard());
    for (const double rate : {30.0, 120.0, 240.0}) {
        const auto other = walk_the_yard(yard(), {.rate = rate});
        for (std::size_t i = 0; i < usual.size(); ++i) {
            EXPECT_LE((other[i] - usual[i]).norm(), 0.05)
                << rate << " Hz, leg " << i << ": " << other[i].transpose() << " instead of "
                << usual[i].transpose();
        }
    }
}

/// A random walk is bit-identical for any order of the triangles.
TEST(CoursePlaces, RandomWalksDoNotDependOnTheTrianglesOrder) {
    const auto digest_of = [](const TriangleMesh& mesh, std::uint32_t seed) {
        auto world = empty_world();
        support::add_object(*world, mesh);
        const support::PenetrationOracle oracle(*world);
        const CapsuleMover mover(*world, {}, {});
        MoverCache cache;
        const auto move = [&](MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
            mover.move(state, desired, seconds, cache, trace);
        };
        support::WalkSettings settings;
        settings.start = {0, 0.01, 0.2};
        settings.seed = seed;
        settings.ticks = 900;
        const support::WalkAudit audit = support::audit_random_walk(oracle, move, settings);
        EXPECT_TRUE(audit.clean()) << "seed " << seed;
        return audit.digest;
    };
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(8)); ++seed) {
        TriangleMesh mesh = yard();
        const std::uint64_t as_built = digest_of(mesh, seed);
        Dice dice(seed + 50);
        shuffle(mesh, dice);
        EXPECT_EQ(digest_of(mesh, seed), as_built) << "seed " << seed;
    }
}

}  // namespace
}  // namespace campuswalk::collision::course
