#include "engine/walkspace/barrier/hollows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "collision/world/cast.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// The air is flooded from cube to cube, by rays between their middles, of the first of these edge lengths
/// with which no more than kMostCubes are filled: a small hollow finely, a hall coarsely. Metres.
constexpr std::array kCubeSizes{0.25, 0.5, 1.0};
constexpr std::size_t kMostCubes = 60'000;

using Cube = std::array<int, 3>;

/// Floods air from column to column: what is free from floor to ceiling is filled at once, so that few of the
/// rays are vertical.
class AirFlood {
public:
    AirFlood(const collision::World& world, const ExploreSettings& settings, const WalkSpace& reached,
             double cube)
        : world_(world),
          solids_(settings.solids),
          reached_(reached),
          body_height_(settings.strides.body.height),
          cube_(cube),
          sky_(world.bounds().max.y() + 1.0),
          abyss_(world.bounds().min.y() - 1.0) {}

    enum class End : std::uint8_t { enclosed, open, too_large };

    End run(const Island& island) {
        for (const UnreachedSpot& spot : island.spots) {
            const Vec3 middle = spot.at.foot + Vec3(0, 0.5 * body_height_, 0);
            const Cube cube = cube_at(middle);
            if (is_free(middle, middle_of(cube))) {
                waiting_.push_back(cube);
            }
        }
        if (waiting_.empty()) {  // all too low to have air of their own
            return End::open;
        }
        for (; !waiting_.empty(); waiting_.pop_front()) {
            const Cube& cube = waiting_.front();
            if (!is_filled(cube) && fill_column(cube)) {
                return End::open;
            }
            if (cubes_ > kMostCubes) {
                return End::too_large;
            }
        }
        return End::enclosed;
    }

private:
    /// From the lowest to the highest cube.
    struct Span {
        int low = 0;
        int high = 0;
    };

    int index_of(double value) const { return static_cast<int>(std::floor(value / cube_)); }
    Cube cube_at(const Vec3& p) const { return {index_of(p.x()), index_of(p.y()), index_of(p.z())}; }
    Vec3 middle_of(const Cube& cube) const {
        return {(cube[0] + 0.5) * cube_, (cube[1] + 0.5) * cube_, (cube[2] + 0.5) * cube_};
    }

    std::optional<double> height_of_hit(const Vec3& from, double y) const {
        const auto hit =
            collision::cast(world_, solids_, {from, {from.x(), y, from.z()}}, collision::Detection::solid);
        return hit ? std::optional(from.y() + hit->fraction * (y - from.y())) : std::nullopt;
    }

    bool is_free(const Vec3& from, const Vec3& to) const {
        return !collision::cast(world_, solids_, {from, to}, collision::Detection::solid);
    }

    bool is_filled(const Cube& cube) const {
        const auto column = filled_.find({cube[0], cube[2]});
        return column != filled_.end() && std::ranges::any_of(column->second, [&](const Span& span) {
                   return span.low <= cube[1] && cube[1] <= span.high;
               });
    }

    /// Whether it is open somewhere.
    bool fill_column(const Cube& cube) {
        const Vec3 middle = middle_of(cube);
        const std::optional<double> floor = height_of_hit(middle, abyss_);
        const std::optional<double> ceiling = height_of_hit(middle, sky_);
        if (!floor || !ceiling || !is_within_world(middle)) {
            return true;
        }
        // The cubes whose middles are between the two; below a skybox, those around this one first.
        constexpr int kCubesAtOnce = 40;
        const double low = std::max(*floor, middle.y() - kCubesAtOnce * cube_);
        const double high = std::min(*ceiling, middle.y() + kCubesAtOnce * cube_);
        const Span span{index_of(low - 0.5 * cube_) + 1, index_of(high - 0.5 * cube_)};
        filled_[{cube[0], cube[2]}].push_back(span);
        for (const int beyond : {span.low - 1, span.high + 1}) {
            const Cube next{cube[0], beyond, cube[2]};
            if (const double y = middle_of(next).y(); *floor < y && y < *ceiling) {
                waiting_.push_back(next);
            }
        }
        Cube each = cube;
        for (each[1] = span.low; each[1] <= span.high; ++each[1]) {
            ++cubes_;
            if (sees_visitor(middle_of(each))) {
                return true;
            }
            add_neighbours(each);
        }
        return false;
    }

    bool is_within_world(const Vec3& point) const { return world_.bounds().overlaps({point, point}); }

    /// One who stands where one gets to.
    bool sees_visitor(const Vec3& point) const {
        const auto node =
            reached_.find(reached_.grid.cell_at(point), point.y() - 0.5 * body_height_, 0.5 * body_height_);
        if (!node) {
            return false;
        }
        const Vec3 foot = reached_.position(*node);
        return is_free(point, {foot.x(), point.y(), foot.z()});
    }

    void add_neighbours(const Cube& cube) {
        for (const std::size_t axis : {0U, 2U}) {
            for (const int side : {-1, 1}) {
                Cube next = cube;
                next[axis] += side;
                if (!is_filled(next) && is_free(middle_of(cube), middle_of(next))) {
                    waiting_.push_back(next);
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
    double abyss_;
    std::map<std::pair<int, int>, std::vector<Span>> filled_;  ///< by column
    std::size_t cubes_ = 0;                                    ///< that are filled
    std::deque<Cube> waiting_;
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
