#include "engine/walkspace/route/taut_path.h"

#include <cmath>
#include <limits>

#include "engine/script/travel.h"

namespace campuswalk::engine {

using collision::Vec3;
using Spot = GroundMap::Spot;
using Path = std::vector<Spot>;

namespace {

/// A line may cut so many cells in a row that have no room at the points that the map looks at.
constexpr int kMostMissed = 1;
/// How far apart a line is looked at, in cells.
constexpr double kSample = 0.5;
/// How often a path is pulled, from one end and then from the other: its vertices move to what it goes round.
constexpr int kPulls = 4;
/// Lines pass things by so much: the body comes to each vertex but for a few centimetres, and a line from
/// there must not touch what it goes round, metres.
constexpr double kVertexRoom = 0.06;

/// The ground below a line may be so far from the line that the body is swept along, metres.
constexpr double kUneven = 0.05;

/// The ground along a straight line from above, point by point.
class GroundProfile {
public:
    GroundProfile(const Vec3& from, const Vec3& to) : from_(from), apart_(flat(to - from)) {
        points_.push_back({0.0, from.y()});
    }

    /// `share`: of the whole line, more than that of the point before.
    void add(double share, double height) { points_.push_back({share, height}); }

    /// By sweeps over as much of the ground as is even.
    bool is_path_free(const GroundMap& map, double beside) const {
        std::size_t at = 0;
        while (at + 1 < points_.size()) {
            const std::size_t next = end_of_even(at);
            if (!map.is_path_free(foot(at), foot(next), beside)) {
                return false;
            }
            at = next;
        }
        return true;
    }

private:
    struct Point {
        double share = 0.0;
        double height = 0.0;
    };

    Vec3 foot(std::size_t i) const {
        Vec3 foot = from_ + points_[i].share * apart_;
        foot.y() = points_[i].height;
        return foot;
    }

    /// The last point that a line leads to which all points between are near.
    std::size_t end_of_even(std::size_t first) const {
        double lowest = -std::numeric_limits<double>::infinity();  // rise of lines that are near all of them
        double highest = std::numeric_limits<double>::infinity();
        std::size_t end = first + 1;
        for (std::size_t i = first + 1; i < points_.size() && lowest <= highest; ++i) {
            const double ahead = points_[i].share - points_[first].share;
            const double rise = points_[i].height - points_[first].height;
            if (lowest * ahead <= rise && rise <= highest * ahead) {
                end = i;
            }
            lowest = std::max(lowest, (rise - kUneven) / ahead);
            highest = std::min(highest, (rise + kUneven) / ahead);
        }
        return end;
    }

    Vec3 from_;
    Vec3 apart_;
    std::vector<Point> points_;
};

bool is_allowed(GroundMap& map, const Spot& spot, const GuessRules& rules) {
    return map.has_room(spot) && std::ranges::find(rules.blocked, spot) == rules.blocked.end() &&
           !(rules.keep_out && rules.keep_out(map.foot(spot)));
}

/// The highest of the cell's spots that is within a step from there.
std::optional<Spot> spot_within_a_step(GroundMap& map, const GridCell& cell, double height, double most_up,
                                       const GuessRules& rules) {
    const GroundMap::Spots spots = map.spots_in(cell);
    for (std::uint32_t i = spots.end; i > spots.first; --i) {
        const Spot spot{spots.tile, i - 1};
        if (is_step(height, map.height(spot), most_up) && is_allowed(map, spot, rules)) {
            return spot;
        }
    }
    return std::nullopt;
}

/// From one end to the other, each piece as long as it can be.
class Puller {
public:
    Puller(GroundMap& map, const Path& path, const GuessRules& rules)
        : map_(map), path_(path), rules_(rules) {}

    Path from_the_front() {
        Path taut{path_.front()};
        std::size_t at = 0;
        while (at + 1 < path_.size()) {
            const std::size_t most = path_.size() - 1 - at;
            const std::size_t length = longest(most, [&](std::size_t n) { return line(at, at + n); });
            taut.insert(taut.end(), best_.begin(), best_.end());
            at += length;
        }
        return taut;
    }

    Path from_the_back() {
        Path backwards;
        std::size_t at = path_.size() - 1;
        while (at > 0) {
            const std::size_t length = longest(at, [&](std::size_t n) { return line(at - n, at); });
            backwards.insert(backwards.end(), best_.rbegin(), best_.rend());
            at -= length;
        }
        backwards.push_back(path_.front());
        std::ranges::reverse(backwards);
        return backwards;
    }

private:
    /// Where the path begins or ends right beside a wall, it leads along that wall.
    double room_at(std::size_t i) const {
        const Vec3 foot = map_.foot(path_[i]);
        const bool is_end = i == 0 || i + 1 == path_.size();
        return is_end && !map_.has_room_beside(foot, kVertexRoom) ? 0.0 : kVertexRoom;
    }

    /// Without its first spot.
    std::optional<Path> line(std::size_t from, std::size_t to) {
        if (to == from + 1) {
            return Path{path_[to]};
        }
        const double room = std::min(room_at(from), room_at(to));
        auto spots = straight_path(map_, map_.foot(path_[from]), map_.foot(path_[to]), rules_, room);
        if (!spots || spots->empty()) {
            return std::nullopt;
        }
        const double apart = map_.height(spots->back()) - map_.height(path_[to]);
        return std::abs(apart) <= kFootLevel ? spots : std::nullopt;  // else on another level
    }

    template <typename Line>
    std::size_t longest(std::size_t most, const Line& line_of) {
        best_ = *line_of(1);
        return farthest_by_leaps(most, [&](std::size_t length) {
            auto spots = line_of(length);
            if (spots) {
                best_ = std::move(*spots);
            }
            return spots.has_value();
        });
    }

    GroundMap& map_;
    const Path& path_;
    const GuessRules& rules_;
    Path best_;  ///< the line of the longest piece
};

}  // namespace

std::optional<Path> straight_path(GroundMap& map, const Vec3& from, const Vec3& to, const GuessRules& rules,
                                  double beside) {
    const Vec3 apart = flat(to - from);
    const int samples = static_cast<int>(std::ceil(apart.norm() / (kSample * map.grid().cell)));
    GridCell cell = map.grid().cell_at(from);
    double height = from.y();
    double most_up = std::max(rules.most_up, kFootLevel);  // it may stand higher than the surface below it
    int missed = 0;
    Path spots;
    GroundProfile profile(from, to);
    for (int i = 1; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const GridCell next = map.grid().cell_at(from + apart * share);
        if (next == cell) {
            continue;
        }
        cell = next;
        if (const auto spot = spot_within_a_step(map, cell, height, most_up, rules)) {
            height = map.height(*spot);
            spots.push_back(*spot);
            profile.add(share, height);
            missed = 0;
        } else if (++missed > kMostMissed) {
            return std::nullopt;
        }
        most_up = rules.most_up;
    }
    return profile.is_path_free(map, beside) ? std::optional(spots) : std::nullopt;
}

Path pulled_taut(GroundMap& map, Path path, const GuessRules& rules) {
    for (int i = 0; i < kPulls && path.size() > 2; ++i) {
        Puller puller(map, path, rules);
        path = i % 2 == 0 ? puller.from_the_front() : puller.from_the_back();
    }
    return path;
}

}  // namespace campuswalk::engine
