#include "engine/walkspace/explore/explore.h"

#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "engine/walkspace/explore/frontier.h"
#include "engine/walkspace/explore/growing_space.h"
#include "engine/walkspace/explore/landing_places.h"
#include "engine/walkspace/explore/stride_worker.h"
#include "engine/walkspace/explore/tile_explorer.h"
#include "engine/walkspace/explore/tile_order.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

namespace {

/// A round plays this many ticks of each walk: short enough for chains to be hardly longer than need be, long
/// enough for a tile to be worth the work of coming to it.
constexpr std::uint32_t kTicksOfRound = 600;
/// Likewise on the way to a goal, where what a round explores too much is wasted.
constexpr std::uint32_t kTicksOfGoalRound = 30;
/// So many falls are steered before what they lead to becomes nodes.
constexpr std::size_t kFallsAtOnce = 64;

FallEdge edge_of(const Fall& fall) {
    return {fall.edge.cast<double>(), fall.gait};
}

class Exploration {
public:
    Exploration(const WorkerWorlds& worlds, const ExploreSettings& settings, const ExploreGoal& goal)
        : worlds_(worlds), settings_(settings), growing_(settings, goal) {
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            workers_.emplace_back(worlds[i], settings, space_, growing_.known());
        }
    }

    WalkSpace run() {
        add_starts();
        growing_.note_goal();
        explore_ground();
        while (!space_.goal && !is_cut_ && steer_falls()) {
            explore_ground();
        }
        return finished();
    }

private:
    struct TileFall {
        std::uint32_t tile = 0;
        Fall fall;
    };

    void add_starts() {
        Strider& strider = workers_.front().strider();
        for (std::size_t i = 0; i < settings_.starts.size(); ++i) {
            const StrideEnd end = strider.put_down(settings_.starts[i]);
            if (end.kind == StrideEnd::Kind::grounded) {
                space_.starts.push_back(growing_.add_start(end.at, strider));
                space_.start_of.push_back(i);
            }
        }
        for (const GroundState& at : settings_.more_starts) {
            growing_.add_start(at, strider);
        }
    }

    /// Without steering in falls.
    void explore_ground() {
        const std::uint32_t round = growing_.policy().has_goal() ? kTicksOfGoalRound : kTicksOfRound;
        std::uint32_t limit = 0;
        while (const auto earliest = space_.goal ? std::nullopt : earliest_pending()) {
            if (*earliest >= settings_.max_ticks) {
                break;
            }
            limit = std::min(std::max(limit, *earliest) + round, settings_.max_ticks);
            explore_tiles(limit);
            growing_.note_goal();
            const std::size_t nodes = space_.node_count();
            if (nodes > settings_.max_nodes) {
                workers_.front().bounds.insert(Bound::nodes);
                is_cut_ = true;
                return;
            }
            if (settings_.progress) {
                settings_.progress(nodes);
            }
        }
    }

    /// Only where there is ground to be reached by that. False if there was no fall left.
    bool steer_falls() {
        std::vector<TileFall> falls;
        std::vector<FallEdge> edges;
        for (std::uint32_t tile = 0; tile < frontiers_.size(); ++tile) {
            for (const Fall& fall : std::exchange(frontiers_[tile].falls, {})) {
                falls.push_back({tile, fall});
                edges.push_back(edge_of(fall));
            }
        }
        if (falls.empty()) {
            return false;
        }
        workers_.front().bounds.insert(Bound::steering);  // not all ways to steer are tried
        if (!settings_.steer_falls) {
            return false;
        }
        const LandingPlaces places(worlds_, settings_, space_, edges);
        for (std::size_t first = 0; first < falls.size() && !space_.goal; first += kFallsAtOnce) {
            const std::size_t count = std::min(kFallsAtOnce, falls.size() - first);
            steer(std::span(falls).subspan(first, count), places);
        }
        return true;
    }

    /// By all threads: no node is added meanwhile.
    void steer(const std::span<const TileFall> falls, const LandingPlaces& places) {
        std::vector<std::vector<SteeredEnd>> ends(falls.size());
        for_each_item(falls.size(), workers_.size(), [&](std::size_t worker, std::size_t i) {
            if (places.has_any_below(edge_of(falls[i].fall))) {
                ends[i] = workers_[worker].steer(falls[i].tile, falls[i].fall);
            }
        });
        std::vector<std::uint32_t> tiles;
        for (std::size_t i = 0; i < falls.size(); ++i) {
            const auto& [tile, fall] = falls[i];
            TileExplorer explorer(settings_, growing_, tile, workers_.front());
            for (const SteeredEnd& each : ends[i]) {
                explorer.note(fall.from(), each.stride, each.end);
            }
            tiles.push_back(tile);
        }
        receive_from(tiles);
        growing_.note_goal();
    }

    std::optional<std::uint32_t> earliest_pending() const {
        std::optional<std::uint32_t> earliest;
        for (const Frontier& frontier : frontiers_) {
            if (!frontier.is_empty()) {
                earliest = std::min(earliest.value_or(frontier.next_order()), frontier.next_order());
            }
        }
        return earliest;
    }

    /// Those in which there is something to do before `limit`, or that one gets to from there.
    void explore_tiles(std::uint32_t limit) {
        std::vector<std::uint32_t> active;
        for (std::uint32_t i = 0; i < frontiers_.size(); ++i) {
            if (!frontiers_[i].is_empty() && frontiers_[i].next_order() < limit) {
                active.push_back(i);
            }
        }
        const TileOrder order =
            order_around(active, space_, [this](std::uint32_t tile) { return rank_of(tile); });
        for_each_item_in_order(order.after, workers_.size(), [&](std::size_t worker, std::size_t item) {
            const std::uint32_t tile = order.tiles[item];
            for (const std::size_t earlier : order.after[item]) {
                take_from(frontiers_[order.tiles[earlier]].outbox, tile, workers_[worker]);
            }
            TileExplorer(settings_, growing_, tile, workers_[worker]).explore(limit);
        });
        receive_from(order.tiles);
    }

    /// As they were reached, or on the way to a point as they promise to lead there, so that what goes on
    /// from one to the next finds places by the shorter paths first.
    std::uint32_t rank_of(std::uint32_t tile) const {
        const Frontier& frontier = frontiers_[tile];
        return frontier.is_empty() ? std::numeric_limits<std::uint32_t>::max() : frontier.next_order();
    }

    /// What came from beside the tile. Other threads may read the same outbox.
    void take_from(const std::vector<Arrival>& outbox, std::uint32_t tile, StrideWorker& worker) {
        for (const Arrival& arrival : outbox) {
            if (space_.tiles[tile].contains(arrival.cell)) {
                growing_.receive(tile, arrival, worker);
            }
        }
    }

    /// What is already received makes no difference.
    void receive_from(const std::vector<std::uint32_t>& tiles) {
        for (const std::uint32_t tile : tiles) {
            for (const Arrival& arrival : std::exchange(frontiers_[tile].outbox, {})) {
                growing_.receive(growing_.tile_for(arrival.cell), arrival, workers_.front());
            }
        }
    }

    WalkSpace finished() {
        std::set<Bound> bounds;
        space_.touched.assign(workers_.front().strider().touched().size(), false);
        for (const StrideWorker& worker : workers_) {
            bounds.insert(worker.bounds.begin(), worker.bounds.end());
            space_.ticks += worker.strider().ticks();
            space_.strides += worker.strides();
            for (std::size_t i = 0; i < space_.touched.size(); ++i) {
                space_.touched[i] = space_.touched[i] || worker.strider().touched()[i];
            }
        }
        space_.bounds.assign(bounds.begin(), bounds.end());
        return std::move(space_);
    }

    const WorkerWorlds& worlds_;
    const ExploreSettings& settings_;
    GrowingSpace growing_;
    WalkSpace& space_ = growing_.space;
    std::vector<Frontier>& frontiers_ = growing_.frontiers;
    std::vector<StrideWorker> workers_;
    bool is_cut_ = false;  ///< by the most nodes
};

}  // namespace

WalkSpace explore(const WorkerWorlds& worlds, const ExploreSettings& settings, const ExploreGoal& goal) {
    if (std::holds_alternative<TowardsPoint>(goal) && worlds.size() != 1) {
        throw std::invalid_argument("an exploration towards a point has one worker");
    }
    return Exploration(worlds, settings, goal).run();
}

}  // namespace campuswalk::engine
