#include "engine/walkspace/barrier/island_sequences.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include "engine/walkspace/barrier/island_approaches.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Longer sequences help nobody.
constexpr int kMostInSequence = 5;
/// Smaller ground over a ledge is the top of something, and nobody misses it, m².
constexpr double kLargeTop = 10.0;
/// A barrier so near another one, metres, is at the same place, and its number is the same if it is no more
/// than that greater, metres or radians.
constexpr double kSameBarrier = 1.0;
constexpr double kSameMeasure = 0.002;

/// The barrier that one comes upon last.
const Barrier& last_of(const Barrier& barrier) {
    return barrier.kind == ReasonKind::sequence ? barrier.parts.back() : barrier;
}

bool is_ledge(const Barrier& barrier) {
    return barrier.kind == ReasonKind::ledge;
}

/// How much harder than what the body manages.
double excess(const Barrier& barrier) {
    return std::abs(barrier.measured - barrier.allowed);
}

/// Ground of islands whose barriers can be overcome.
class OvercomeGround {
public:
    OvercomeGround(const WalkGrid& grid, double step) : space_(grid), step_(step) {}

    /// Ways are looked for from these only: those that the barriers before led to last.
    void go_on_to(const std::vector<Island>& islands, const std::vector<std::size_t>& last) {
        for (const std::size_t i : last) {
            for (const UnreachedSpot& spot : islands[i].spots) {
                add(spot.at.foot, i);
            }
        }
        rim_ = {};
        for (const std::size_t i : last) {
            for (const UnreachedSpot& spot : islands[i].spots) {
                if (has(spot.at.foot) && is_at_edge(spot.at.foot)) {
                    rim_.add(spot.at.foot, spot.at);
                }
            }
        }
    }

    const WalkSpace& space() const { return space_; }
    const Rim& rim() const { return rim_; }

    /// The island that has a spot there.
    std::size_t island_at(const Vec3& foot) const {
        return island_of_.at(*space_.find(space_.grid.cell_at(foot), foot.y()));
    }

private:
    void add(const Vec3& foot, std::size_t island) {
        const GridCell cell = space_.grid.cell_at(foot);
        if (space_.find(cell, foot.y())) {
            return;
        }
        const std::uint32_t number = space_.add_tile_at(cell);
        WalkTile& tile = space_.tiles[number];
        if (tile.nodes.size() < WalkTile::kMaxNodes) {
            WalkNode node;
            node.y = static_cast<float>(foot.y());
            node.cell = tile.index_of(cell) & 255U;
            node.parent_tile = WalkNode::kStart;
            island_of_.emplace(WalkNodeId{number, tile.add(node)}, island);
        }
    }

    /// Not if its tile was full.
    bool has(const Vec3& foot) const { return space_.find(space_.grid.cell_at(foot), foot.y()).has_value(); }

    bool is_at_edge(const Vec3& foot) const {
        const GridCell cell = space_.grid.cell_at(foot);
        return !space_.find({cell.x + 1, cell.z}, foot.y(), step_) ||
               !space_.find({cell.x - 1, cell.z}, foot.y(), step_) ||
               !space_.find({cell.x, cell.z + 1}, foot.y(), step_) ||
               !space_.find({cell.x, cell.z - 1}, foot.y(), step_);
    }

    WalkSpace space_;  ///< a node at each spot
    double step_;
    Rim rim_;
    std::map<WalkNodeId, std::size_t> island_of_;
};

/// How one gets to an island from another one.
struct Link {
    std::size_t from = 0;            ///< the other one
    std::optional<Barrier> barrier;  ///< between them; none if the body gets there as it is
};

class SequenceSearch {
public:
    SequenceSearch(const ExplainedIslands& all, std::vector<std::optional<Barrier>>& barriers)
        : all_(all),
          barriers_(barriers),
          ground_(all.reached.grid, all.settings.strides.body.step_height + collision::kHeightSlack) {}

    void run() {
        std::vector<std::size_t> fresh;
        for (std::size_t i = 0; i < barriers_.size(); ++i) {
            if (barriers_[i] && is_one_change(barriers_[i]->kind)) {
                fresh.push_back(i);
            }
        }
        for (int length = 2; length <= kMostInSequence && !fresh.empty(); ++length) {
            fresh = go_on_from(fresh);
        }
    }

private:
    /// `fresh`: whose barrier was found last. Returns those whose barrier is found or confirmed now.
    std::vector<std::size_t> go_on_from(const std::vector<std::size_t>& fresh) {
        std::vector<std::size_t> last;
        std::vector<std::size_t> asked;
        for (const std::size_t i : fresh) {
            (is_measured_at_another(i, fresh) ? asked : last).push_back(i);
        }
        std::vector<std::size_t> found = asked;  // if nothing better is found, what they have will do
        for (std::size_t i = 0; i < barriers_.size(); ++i) {
            if (is_worth_asking(i)) {
                asked.push_back(i);
            }
        }
        ground_.go_on_to(all_.islands, last);
        std::vector<std::optional<Link>> links(asked.size());
        for_each_item(asked.size(), all_.worlds.size(), [&](std::size_t worker, std::size_t k) {
            links[k] = link_to(asked[k], WorkerWorlds(all_.worlds[worker], 1, {}));
        });
        const std::size_t known = found.size();
        for (std::size_t k = 0; k < asked.size(); ++k) {
            if (links[k]) {
                barriers_[asked[k]] = in_sequence(*barriers_[links[k]->from], links[k]->barrier);
                if (k >= known && !is_ledge(last_of(*barriers_[asked[k]]))) {
                    found.push_back(asked[k]);
                }
            }
        }
        return found;
    }

    bool is_worth_asking(std::size_t i) const {
        const double area = all_.islands[i].area(all_.reached.grid);
        if (is_top(i)) {
            return is_wanted(i) || area > kLargeTop;
        }
        const bool says_nothing = !barriers_[i] || barriers_[i]->kind == ReasonKind::solid ||
                                  barriers_[i]->kind == ReasonKind::several;
        return (is_wanted(i) || area > kNotableIsland) && says_nothing;
    }

    bool is_wanted(std::size_t i) const { return i < all_.wanted.size() && all_.wanted[i]; }

    /// Of what nobody climbs.
    bool is_top(std::size_t i) const { return barriers_[i] && is_ledge(*barriers_[i]); }

    /// Whether the change that leads to the island was measured before another one on the way, for which less
    /// is enough: its number is that of a barrier farther on.
    bool is_measured_at_another(std::size_t i, const std::vector<std::size_t>& fresh) const {
        const Barrier& own = last_of(*barriers_[i]);
        return std::ranges::any_of(fresh, [&](std::size_t other) {
            const Barrier& before = last_of(*barriers_[other]);
            return other != i && before.kind == own.kind && excess(own) > excess(before) + kSameMeasure &&
                   ((before.at - own.at).norm() <= kSameBarrier || lies_between(own.at, other, i));
        });
    }

    /// Whether one island begins there and the other one farther on.
    bool lies_between(const Vec3& place, std::size_t nearer, std::size_t farther) const {
        constexpr double kMuchNearer = 0.3;  // metres
        const Island& island = all_.islands[nearer];
        if (!island.bounds.grown(kSameBarrier).overlaps({place, place})) {
            return false;
        }
        const double apart = (island.nearest_to(place) - place).norm();
        return apart <= kSameBarrier &&
               (all_.islands[farther].nearest_to(place) - place).norm() >= apart + kMuchNearer;
    }

    IslandQuestion question(std::size_t i, const WorkerWorlds& worlds) const {
        return {worlds,        all_.settings, all_.reached,    all_.islands[i],
                ground_.rim(), all_.nodes,    &ground_.space()};
    }

    std::optional<Link> link_to(std::size_t i, const WorkerWorlds& worlds) const {
        const IslandQuestion q = question(i, worlds);
        const std::vector<Approach> approaches = approaches_to(q);
        if (!approaches.empty() && lowest_of(approaches).rise() <= kHighestLedge) {
            // To a top that nobody wants, no more is tried than is quick: most are what they seem.
            const bool is_high = !barriers_[i] && lowest_of(approaches).rise() > kHighestRiser;
            const bool is_quick = !is_wanted(i) && (is_top(i) || is_high);
            if (auto link = link_by(i, q, passage_nearby(q, approaches), is_quick)) {
                return link;
            }
        }
        const auto afar = is_wanted(i) ? passage_from_afar(q, Changes::single) : std::nullopt;
        return afar ? link_by(i, q, *afar, false) : std::nullopt;
    }

    std::optional<Link> link_by(std::size_t i, const IslandQuestion& q, PassageQuery passage,
                                bool is_quick) const {
        passage.steer_falls = !is_quick;
        passage.changes = is_quick ? Changes::body : Changes::single;
        const WhyNot answer = why_not(q.worlds, q.settings, passage);
        if (std::holds_alternative<Passable>(answer)) {
            return Link{start_of_passage(q, passage), std::nullopt};
        }
        std::optional<Barrier> barrier = barrier_in(answer);
        const bool is_said = is_one_change(barrier->kind) || (is_wanted(i) && is_ledge(*barrier));
        const bool is_better = is_said && says_more(*barrier, i);
        return is_better ? std::optional(Link{island_near(barrier->from, passage), std::move(barrier)})
                         : std::nullopt;
    }

    /// Than the barrier that is known: of those that are measured at another, and of ledges, no more than the
    /// same number.
    bool says_more(const Barrier& link, std::size_t i) const {
        if (!barriers_[i]) {
            return true;
        }
        const Barrier& known = last_of(*barriers_[i]);
        if (!is_one_change(known.kind) && !(is_ledge(known) && is_ledge(link))) {
            return true;
        }
        return link.kind == known.kind && excess(link) <= excess(known) + kSameMeasure;
    }

    /// The island from which the body gets there as it is, the nearest if there are several.
    std::size_t start_of_passage(const IslandQuestion& q, PassageQuery passage) const {
        const std::vector<GroundState> starts = std::exchange(passage.from, {});
        std::vector<std::size_t> islands;
        for (const GroundState& start : starts) {
            const std::size_t island = ground_.island_at(start.foot);
            if (std::ranges::find(islands, island) == islands.end()) {
                islands.push_back(island);
            }
        }
        const std::size_t last = islands.back();
        islands.pop_back();  // if it is none of the others, it needn't be tried
        for (const std::size_t island : islands) {
            passage.from.clear();
            std::ranges::copy_if(starts, std::back_inserter(passage.from), [&](const GroundState& start) {
                return ground_.island_at(start.foot) == island;
            });
            if (std::holds_alternative<Passable>(why_not(q.worlds, q.settings, passage))) {
                return island;
            }
        }
        return last;
    }

    /// The island of the start that is nearest to where the body was stopped.
    std::size_t island_near(const Vec3& foot, const PassageQuery& passage) const {
        const auto nearest = std::ranges::min_element(
            passage.from, {}, [&](const GroundState& start) { return (start.foot - foot).squaredNorm(); });
        return ground_.island_at(nearest->foot);
    }

    static Barrier in_sequence(const Barrier& first, const std::optional<Barrier>& next) {
        if (!next) {
            return first;
        }
        Barrier all = first;
        all.kind = ReasonKind::sequence;
        all.measured = 0.0;
        all.allowed = 0.0;
        all.is_node = false;
        if (first.kind != ReasonKind::sequence) {
            all.parts = {first};
        }
        all.parts.push_back(*next);
        return all;
    }

    const ExplainedIslands& all_;
    std::vector<std::optional<Barrier>>& barriers_;
    OvercomeGround ground_;
};

}  // namespace

void find_sequences(const ExplainedIslands& all, std::vector<std::optional<Barrier>>& barriers) {
    SequenceSearch(all, barriers).run();
}

}  // namespace campuswalk::engine
