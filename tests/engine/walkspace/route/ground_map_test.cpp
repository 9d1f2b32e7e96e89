#include "engine/walkspace/route/ground_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/walkspace/route/guessed_path.h"
#include "engine/walkspace/route/taut_path.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// From a square of `half_size` about (x, z), seen from above, metres.
double distance_to_square(const Vec3& p, double half_size) {
    const double x = std::max(0.0, std::abs(p.x()) - half_size);
    const double z = std::max(0.0, std::abs(p.z()) - half_size);
    return std::sqrt(x * x + z * z);
}

/// A block of 2 m x 2 m about the origin, too high to step onto.
struct Block {
    Block() : campus(level_campus(10.0)) { add_box(campus, "block", {-1, 0, -1}, {1, 3, 1}); }

    GroundMap map() const { return {campus.world, body, {}}; }

    scene::Campus campus;
    collision::MoverSettings body;
};

std::vector<GroundMap::Spot> ground_in(GroundMap& map, const GridCell& cell) {
    std::vector<GroundMap::Spot> found;
    const GroundMap::Spots spots = map.spots_in(cell);
    for (std::uint32_t i = spots.first; i < spots.end; ++i) {
        if (std::abs(map.height({spots.tile, i})) < 0.1) {
            found.push_back({spots.tile, i});
        }
    }
    return found;
}

TEST(GroundMap, HasRoomWhereTheBodyFits) {
    const Block block;
    GroundMap map = block.map();
    const double farthest = map.grid().cell / 3.0 * std::sqrt(2.0);
    for (int z = -12; z < 12; ++z) {
        for (int x = -12; x < 12; ++x) {
            for (const GroundMap::Spot& spot : ground_in(map, {x, z})) {
                const double apart = distance_to_square(map.grid().center({x, z}), 1.0);
                if (map.has_room(spot)) {
                    EXPECT_GE(distance_to_square(map.foot(spot), 1.0), block.body.radius - 1e-9);
                    EXPECT_GE(apart, block.body.radius - farthest);
                } else {
                    EXPECT_LT(apart, block.body.radius);
                }
            }
        }
    }
}

TEST(GroundMap, PrefersPointsWithMoreRoom) {
    const Block block;
    GroundMap map = block.map();
    for (int z = -12; z < 12; ++z) {
        for (int x = -12; x < 12; ++x) {
            for (const GroundMap::Spot& spot : ground_in(map, {x, z})) {
                const double apart = distance_to_square(map.grid().center({x, z}), 1.0);
                const double third = map.grid().cell / 3.0;
                if (map.has_room(spot) && apart > block.body.radius + 0.07 - third && apart < 1.0) {
                    EXPECT_GT(distance_to_square(map.foot(spot), 1.0), block.body.radius + 0.07 - 1e-9);
                }
            }
        }
    }
}

TEST(GroundMap, DoesNotDependOnWhatWasAskedBefore) {
    const Block block;
    GroundMap forwards = block.map();
    GroundMap backwards = block.map();
    std::vector<Vec3> first;
    std::vector<Vec3> second;
    const auto collect = [](GroundMap& map, int x, int z, std::vector<Vec3>& out) {
        for (const GroundMap::Spot& spot : ground_in(map, {x, z})) {
            if (map.has_room(spot)) {
                out.push_back(map.foot(spot));
            }
        }
    };
    for (int i = -40; i < 40; ++i) {
        collect(forwards, i, i / 2, first);
        collect(backwards, -1 - i, (-1 - i) / 2, second);
    }
    std::ranges::reverse(second);
    EXPECT_GT(first.size(), 50U);
    EXPECT_EQ(first, second);
}

TEST(GroundMaps, KeepsOneForEachBodyAndSetOfObjects) {
    const Block block;
    GroundMaps maps;
    std::vector<bool> disabled(block.campus.world.size(), false);
    collision::QueryFilter filter;
    filter.disabled = &disabled;
    GroundMap& all = maps.of(block.campus.world, block.body, filter);
    EXPECT_EQ(&maps.of(block.campus.world, block.body, filter), &all);
    disabled.back() = true;  // the same vector, as when a door opens
    GroundMap& without_block = maps.of(block.campus.world, block.body, filter);
    const GridCell middle{0, 0};
    EXPECT_TRUE(without_block.has_room(ground_in(without_block, middle).at(0)));
    disabled.back() = false;
    GroundMap& again = maps.of(block.campus.world, block.body, filter);
    EXPECT_FALSE(again.has_room(ground_in(again, middle).at(0)));
}

double length_of(GroundMap& map, const std::vector<GroundMap::Spot>& path) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length += (map.foot(path[i]) - map.foot(path[i - 1])).norm();
    }
    return length;
}

TEST(GuessedPath, GoesAlongAxesAndDiagonals) {
    const scene::Campus campus = level_campus(10.0);
    GroundMap map(campus.world, {}, {});
    const auto path = guess_path(map, {-3, 0, 1}, {"", {4, 0, 5}, true}, {});
    ASSERT_TRUE(path);
    EXPECT_NEAR(length_of(map, *path), 3.0 + 4.0 * std::sqrt(2.0), 2.0 * map.grid().cell);
}

TEST(GuessedPath, DoesNotLookForWhatIsTooFar) {
    const scene::Campus campus = level_campus(10.0);
    GroundMap map(campus.world, {}, {});
    for (const double far : {1e6, 1e10, 1e300}) {
        EXPECT_FALSE(guess_path(map, {0, 0, 0}, {"", {far, 0, 0}, true}, {}));
        EXPECT_FALSE(guess_path(map, {far, 0, 0}, {"", {0, 0, far}, true}, {}));
    }
}

TEST(GuessedPath, DoesNotClimbWhatIsTooHigh) {
    for (const double height : {0.28, 0.34}) {
        scene::Campus campus = level_campus(10.0);
        add_box(campus, "tier", {-2, 0, -2}, {2, height, 2});
        GroundMap map(campus.world, {}, {});
        const auto path = guess_path(map, {-6, 0, 0}, {"", {0, height, 0}, true}, {});
        EXPECT_EQ(path.has_value(), height < collision::MoverSettings().step_height) << height;
    }
}

TEST(GuessedPath, KeepsAwayFromWhatIsBlocked) {
    const scene::Campus campus = level_campus(10.0);
    GroundMap map(campus.world, {}, {});
    GuessRules rules;
    const Target goal{"", {4.1, 0, 0.1}, true};
    const auto straight = guess_path(map, {-4.1, 0, 0.1}, goal, rules);
    ASSERT_TRUE(straight);
    rules.blocked.push_back((*straight)[straight->size() / 2]);
    const auto round = guess_path(map, {-4.1, 0, 0.1}, goal, rules);
    ASSERT_TRUE(round);
    EXPECT_EQ(std::ranges::find(*round, rules.blocked.front()), round->end());
}

/// Of straight lines, each to the farthest spot of the path that one leads to.
double length_of_lines(GroundMap& map, const std::vector<GroundMap::Spot>& path) {
    double length = 0.0;
    Vec3 at = map.foot(path.front());
    for (std::size_t i = 1; i < path.size();) {
        std::size_t last = i;
        for (std::size_t k = i; k < path.size(); ++k) {
            last = straight_path(map, at, map.foot(path[k]), {}) ? k : last;
        }
        length += (map.foot(path[last]) - at).norm();
        at = map.foot(path[last]);
        i = last + 1;
    }
    return length;
}

TEST(TautPath, LiesRoundABlock) {
    const Block block;
    GroundMap map = block.map();
    const Vec3 from(-4, 0, 0.1);
    const Vec3 to(4, 0, -0.1);
    const auto guess = guess_path(map, from, {"", to, true}, {});
    ASSERT_TRUE(guess);
    const auto taut = pulled_taut(map, *guess, {});
    // Over the two vertices that are a body's radius away from the block's.
    const double r = block.body.radius;
    const double around = 2.0 * std::sqrt((3.0 - r) * (3.0 - r) + (1.0 + r) * (1.0 + r)) + 2.0 + 2.0 * r;
    const double length = length_of_lines(map, taut);
    EXPECT_LT(length, around + 0.2) << "along axes and diagonals it would be 0.5 more";
    EXPECT_GT(length, around - map.grid().cell) << "its ends are in the cells of those asked for";
}

TEST(TautPath, TouchesNothing) {
    const Block block;
    GroundMap map = block.map();
    for (int i = 0; i < 40; ++i) {  // from (-3, -1.6) past the block's vertex at (-1, -1), ever nearer
        const Vec3 to(3, 0, -2.2 + 0.05 * i);
        const Vec3 from(-3, 0, -1.6);
        double nearest = 1e300;
        for (int k = 0; k <= 1000; ++k) {
            nearest = std::min(nearest, distance_to_square(from + k / 1000.0 * (to - from), 1.0));
        }
        for (const double beside : {0.0, 0.1}) {
            const double needed = block.body.radius + beside;
            if (std::abs(nearest - needed) > 0.005) {
                EXPECT_EQ(straight_path(map, from, to, {}, beside).has_value(), nearest > needed)
                    << nearest << ' ' << beside;
            }
        }
    }
}

TEST(TautPath, LeadsUpStairsAndOverKerbs) {
    scene::Campus campus = level_campus(10.0);
    for (int i = 0; i < 10; ++i) {
        add_box(campus, "step", {1.0 + 0.3 * i, 0, -2}, {1.3 + 0.3 * i, 0.17 * (i + 1), 2});
    }
    add_box(campus, "kerb", {-2, 0, -9}, {-1.5, 0.15, 9});
    GroundMap map(campus.world, {}, {});
    EXPECT_TRUE(straight_path(map, {-4, 0, 0.1}, {3.9, 1.7, 0.3}, {}, 0.05));
}

TEST(TautPath, LeadsOverLevelGroundForBodiesThatClimbNothing) {
    const Block block;
    for (const double step : {0.0, 0.02}) {
        collision::MoverSettings body;
        body.step_height = step;
        GroundMap map(block.campus.world, body, {});
        EXPECT_TRUE(straight_path(map, {-4, 0, 3}, {4, 0, 3}, {}, 0.05)) << step;
        EXPECT_FALSE(straight_path(map, {-4, 0, 0}, {4, 0, 0}, {})) << step;
    }
}

TEST(TautPath, LiesStraightOnAPavement) {
    scene::Campus campus = level_campus(10.0);  // with ground below the pavement, too
    add_box(campus, "pavement", {-6, 0, -6}, {6, 0.06, 6});
    GroundMap map(campus.world, {}, {});
    const auto guess = guess_path(map, {-5, 0.06, 0.1}, {"", {5, 0.06, 2.1}, true}, {});
    ASSERT_TRUE(guess);
    const auto taut = pulled_taut(map, *guess, {});
    const double straight = (map.foot(taut.back()) - map.foot(taut.front())).norm();
    EXPECT_NEAR(length_of_lines(map, taut), straight, 1e-9);
    double farthest = 0.0;  // from the line
    for (const GroundMap::Spot& spot : taut) {
        const Vec3 along = (map.foot(taut.back()) - map.foot(taut.front())) / straight;
        const Vec3 p = map.foot(spot) - map.foot(taut.front());
        farthest = std::max(farthest, (p - p.dot(along) * along).norm());
    }
    EXPECT_LT(farthest, 0.2) << "the way from cell to cell strays by 0.8 m";
}

TEST(TautPath, IsBlockedByAWall) {
    const Block block;
    GroundMap map = block.map();
    EXPECT_FALSE(straight_path(map, {-4, 0, 0}, {4, 0, 0}, {}));
    EXPECT_TRUE(straight_path(map, {-4, 0, 3}, {4, 0, 3}, {}));
}

TEST(Leaps, FindTheFarthest) {
    for (std::size_t most = 1; most < 40; ++most) {
        for (std::size_t limit = 1; limit <= most; ++limit) {
            EXPECT_EQ(farthest_by_leaps(most, [&](std::size_t n) { return n <= limit; }), limit);
        }
    }
}

TEST(Leaps, LookBeyondWhatDoesNotWork) {
    const auto works = [](std::size_t n) { return n <= 3 || (n >= 20 && n <= 50); };
    EXPECT_EQ(farthest_by_leaps(100, works), 50U);
}

// The shortest way from cell to cell runs up to the column's front. A string leaves the gate's post for its
// side.
TEST(TautPath, LiesRoundAColumnBehindAGate) {
    scene::Campus campus = level_campus(30.0);
    constexpr double kColumn = 3.0;
    for (const double side : {-1.0, 1.0}) {
        add_box(campus, "post", {side * 1.5 - 0.5, 0, 9}, {side * 1.5 + 0.5, 3, 10});
    }
    add_object(campus, "column", collision::Capsule{kColumn, 6.0}, {0, 1, 0});
    GroundMap map(campus.world, {}, {});
    const Vec3 from(0.1, 0, 25);
    const Vec3 to(0.1, 0, -25);
    const auto guess = guess_path(map, from, {"", to, true}, {});
    ASSERT_TRUE(guess);
    const double length = length_of_lines(map, pulled_taut(map, *guess, {}));
    // A string round what is a body's radius away from the post and the column.
    const double r = collision::MoverSettings().radius;
    const Vec3 post(1.0 - r, 0, 9.0);
    const double round = kColumn + r;
    const auto tangent = [&](const Vec3& p) { return std::sqrt(p.squaredNorm() - round * round); };
    const auto seen = [&](const Vec3& p) { return std::acos(round / p.norm()); };
    const double turn = std::acos(post.dot(to) / (post.norm() * to.norm())) - seen(post) - seen(to);
    const double string = (post - from).norm() + tangent(post) + turn * round + tangent(to);
    EXPECT_LT(length, string + 0.25);
    EXPECT_GT(length, string - 2.0 * map.grid().cell);
}

}  // namespace
}  // namespace campuswalk::engine
