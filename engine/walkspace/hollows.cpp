#include "engine/walkspace/hollows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <set>

#include "collision/world/cast.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// The air is flooded from cube to cube, by rays between their middles, of the first of these edge lengths
/// with which no more than kMostCubes are filled: a small hollow finely, a hall coarsely. Metres.
constexpr std::array kCubeSizes{0.25, 0.5, 1.0};
constexpr std::size_t kMostCubes = 60'000;

using Cube = std::array<int, 3>;

class AirFlood {
public:
    AirFlood(const collision::World& world, const ExploreSettings& settings, const WalkSpace& reached,
             double cube)
        : world_(world),
          solids_(settings.solids),
          reached_(reached),
          body_height_(settings.strides.body.height),
          cube_(cube),
          sky_(world.bounds().max.y() + 1.0) {}

    enum class End : std::uint8_t { enclosed, open, too_large };

    End run(const Island& island) {
        for (const UnreachedSpot& spot : island.spots) {
            const Vec3 middle = spot.at.foot + Vec3(0, 0.5 * body_height_, 0);
            const Cube cube = cube_at(middle);
            if (is_free(middle, middle_of(cube)) && seen_.insert(cube).second) {
                queue_.push_back(cube);
            }
        }
        if (queue_.empty()) {  // all too low to have air of their own
            return End::open;
        }
        for (; !queue_.empty(); queue_.pop_front()) {
            const Cube cube = queue_.front();
            if (is_open(middle_of(cube))) {
                return End::open;
            }
            if (seen_.size() > kMostCubes) {
                return End::too_large;
            }
            add_neighbours(cube);
        }
        return End::enclosed;
    }

private:
    Cube cube_at(const Vec3& p) const {
        const auto index = [&](double value) { return static_cast<int>(std::floor(value / cube_)); };
        return {index(p.x()), index(p.y()), index(p.z())};
    }
    Vec3 middle_of(const Cube& cube) const {
        return {(cube[0] + 0.5) * cube_, (cube[1] + 0.5) * cube_, (cube[2] + 0.5) * cube_};
    }

    bool is_free(const Vec3& from, const Vec3& to) const {
        return !collision::cast(world_, solids_, {from, to}, collision::Detection::solid);
    }

    /// Whether the sky, the rim of the world or a visitor who gets to stand there is seen from a point.
    bool is_open(const Vec3& point) const {
        if (!world_.bounds().overlaps({point, point}) || is_free(point, {point.x(), sky_, point.z()})) {
            return true;
        }
        const auto node =
            reached_.find(reached_.grid.cell_at(point), point.y() - 0.5 * body_height_, 0.5 * body_height_);
        if (!node) {
            return false;
        }
        const Vec3 foot = reached_.position(*node);
        return is_free(point, {foot.x(), point.y(), foot.z()});
    }

    void add_neighbours(const Cube& cube) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int side : {-1, 1}) {
                Cube next = cube;
                next[axis] += side;
                if (!seen_.contains(next) && is_free(middle_of(cube), middle_of(next))) {
                    seen_.insert(next);
                    queue_.push_back(next);
                }
            }
        }
    }

    const collision::World& world_;
    const collision::QueryFilter& solids_;
    const WalkSpace& reached_;
    double body_height_;
    double cube_;
    double sky_;
    std::set<Cube> seen_;
    std::deque<Cube> queue_;
};

}  // namespace

bool is_enclosed(const collision::World& world, const ExploreSettings& settings, const WalkSpace& reached,
                 const Island& island) {
    for (const double cube : kCubeSizes) {
        AirFlood flood(world, settings, reached, cube);
        const AirFlood::End end = flood.run(island);
        if (end != AirFlood::End::too_large) {
            return end == AirFlood::End::enclosed;
        }
    }
    return false;
}

}  // namespace campuswalk::engine
