#include "engine/walkspace/route/guessed_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "engine/script/travel.h"
#include "engine/walkspace/explore/explore.h"

namespace campuswalk::engine {

using collision::Vec3;
using Spot = GroundMap::Spot;

namespace {

/// Costs are of whole thousandths of a cell, so that sums don't depend on their order.
constexpr std::uint32_t kAcross = 1000;
constexpr std::uint32_t kDiagonally = 1414;
/// Farther from the origin, or apart, the numbers of cells and costs don't fit, metres.
constexpr double kFarthest = 1e8;
constexpr double kFarthestApart = 1e5;
/// Spots that are looked at before it is left to walking, which sees more.
constexpr std::size_t kMostSpots = 400'000;

struct Open {
    /// The estimate of the whole way, then what is left of it: of two with the same estimate, the one that is
    /// farther on is the better one.
    std::uint64_t order = 0;
    std::uint32_t cost = 0;  ///< so far
    Spot spot;
    GridCell cell;
};

/// The better one first, at the top of a heap.
bool is_worse(const Open& a, const Open& b) {
    return a.order != b.order ? a.order > b.order
                              : std::tuple(a.cell, a.spot.number) > std::tuple(b.cell, b.spot.number);
}

class Search {
public:
    Search(GroundMap& map, const Target& to, const GuessRules& rules)
        : map_(map), rules_(rules), to_(to), goal_(map.grid().cell_at(to.point)) {}

    std::optional<std::vector<Spot>> run(const Vec3& from) {
        add_starts(from);
        std::size_t looked_at = 0;
        while (!open_.empty() && looked_at < kMostSpots) {
            const Open next = pop();
            Mark& mark = mark_of(next.spot);
            if (mark.closed) {
                continue;
            }
            mark.closed = true;
            ++looked_at;
            if (is_goal(next)) {
                return path_to(next.spot);
            }
            expand(next);
        }
        return std::nullopt;
    }

private:
    static constexpr std::uint32_t kFar = 0xFFFFFFFF;
    enum class Allowed : std::uint8_t { unknown, yes, tightly, no };
    struct Mark {
        std::uint32_t cost = kFar;
        Spot from;  ///< itself at the start
        Allowed allowed = Allowed::unknown;
        bool closed = false;
    };

    Mark& mark_of(const Spot& spot) {
        if (spot.tile >= marks_.size()) {
            marks_.resize(spot.tile + 1);
        }
        std::vector<Mark>& marks = marks_[spot.tile];
        if (marks.empty()) {
            marks.resize(map_.count(spot.tile));
        }
        return marks[spot.number];
    }

    /// The body's own cell; where that has no room by the map, those around.
    void add_starts(const Vec3& from) {
        const GridCell own = map_.grid().cell_at(from);
        for (int ring = 0; ring <= 1 && open_.empty(); ++ring) {
            for (int z = -ring; z <= ring; ++z) {
                for (int x = -ring; x <= ring; ++x) {
                    const GridCell cell{own.x + x, own.z + z};
                    for_each_spot(cell, [&](const Spot& spot) {
                        if (std::abs(map_.height(spot) - from.y()) <= kFootLevel &&
                            allowed(spot) != Allowed::no) {
                            push(spot, cell, 0, spot);
                        }
                    });
                }
            }
        }
    }

    template <typename Visit>
    void for_each_spot(const GridCell& cell, const Visit& visit) {
        const GroundMap::Spots spots = map_.spots_in(cell);
        for (std::uint32_t i = spots.first; i < spots.end; ++i) {
            visit(Spot{spots.tile, i});
        }
    }

    Allowed allowed(const Spot& spot) {
        Mark& mark = mark_of(spot);
        if (mark.allowed == Allowed::unknown) {
            if (!map_.has_room(spot) || std::ranges::find(rules_.blocked, spot) != rules_.blocked.end() ||
                (rules_.keep_out && rules_.keep_out(map_.foot(spot)))) {
                mark.allowed = Allowed::no;
            } else {
                mark.allowed =
                    rules_.is_tight && rules_.is_tight(map_.foot(spot)) ? Allowed::tightly : Allowed::yes;
            }
        }
        return mark.allowed;
    }

    /// To the cells beside it, and across those corners that have room on one side.
    void expand(const Open& from) {
        std::array<bool, 4> has_room{};
        for (std::size_t i = 0; i < 4; ++i) {
            has_room[i] = step(from, grid_directions()[i], kAcross);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (has_room[i] || has_room[(i + 1) % 4]) {
                step(from, grid_directions()[4 + i], kDiagonally);
            }
        }
    }

    /// False if the body has no room there.
    bool step(const Open& from, const GridDirection& direction, std::uint32_t length) {
        const GridCell cell{from.cell.x + direction.x, from.cell.z + direction.z};
        const double height = map_.height(from.spot);
        bool has_room = false;
        for_each_spot(cell, [&](const Spot& spot) {
            if (!is_step(height, map_.height(spot), rules_.most_up)) {
                return;
            }
            const Allowed how = allowed(spot);
            if (how == Allowed::no) {
                return;
            }
            has_room = true;
            push(spot, cell, from.cost + (how == Allowed::tightly ? kTightFactor : 1U) * length, from.spot);
        });
        return has_room;
    }

    void push(const Spot& spot, const GridCell& cell, std::uint32_t cost, const Spot& from) {
        Mark& mark = mark_of(spot);
        if (cost >= mark.cost) {
            return;
        }
        mark.cost = cost;
        mark.from = from;
        const std::uint32_t left = estimate(cell);
        const std::uint64_t whole = cost + left;
        open_.push_back({whole << 32U | left, cost, spot, cell});
        std::ranges::push_heap(open_, is_worse);
    }

    Open pop() {
        std::ranges::pop_heap(open_, is_worse);
        const Open next = open_.back();
        open_.pop_back();
        return next;
    }

    std::uint32_t estimate(const GridCell& cell) const {
        const auto x = static_cast<std::uint32_t>(std::abs(cell.x - goal_.x));
        const auto z = static_cast<std::uint32_t>(std::abs(cell.z - goal_.z));
        return kAcross * (std::max(x, z) - std::min(x, z)) + kDiagonally * std::min(x, z);
    }

    bool is_goal(const Open& at) const {
        return std::abs(at.cell.x - goal_.x) <= 1 && std::abs(at.cell.z - goal_.z) <= 1 &&
               flat(map_.foot(at.spot) - to_.point).norm() <= map_.grid().cell &&
               (!to_.has_height || std::abs(map_.height(at.spot) - to_.point.y()) <= kTargetLevel);
    }

    std::vector<Spot> path_to(Spot spot) {
        std::vector<Spot> path{spot};
        while (mark_of(spot).from != spot) {
            spot = mark_of(spot).from;
            path.push_back(spot);
        }
        std::ranges::reverse(path);
        return path;
    }

    GroundMap& map_;
    const GuessRules& rules_;
    const Target& to_;
    GridCell goal_;
    std::vector<std::vector<Mark>> marks_;  ///< by tile and spot
    std::vector<Open> open_;                ///< a heap
};

}  // namespace

bool is_step(double from, double to, double most_up) {
    return to - from <= most_up + collision::kHeightSlack && from - to <= kHarmlessFall;
}

std::optional<std::vector<Spot>> guess_path(GroundMap& map, const Vec3& from, const Target& to,
                                            const GuessRules& rules) {
    const double from_middle = std::max(from.cwiseAbs().maxCoeff(), to.point.cwiseAbs().maxCoeff());
    if (!(from_middle <= kFarthest) || !(flat(to.point - from).norm() <= kFarthestApart)) {
        return std::nullopt;
    }
    return Search(map, to, rules).run(from);
}

}  // namespace campuswalk::engine
