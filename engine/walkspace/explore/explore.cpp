#include "engine/walkspace/explore/explore.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "engine/walkspace/explore/frontier.h"
#include "engine/walkspace/explore/known_cells.h"
#include "engine/walkspace/explore/landing_places.h"
#include "engine/walkspace/explore/path_order.h"
#include "engine/walkspace/explore/stride_worker.h"
#include "engine/walkspace/explore/tile_order.h"
#include "engine/walkspace/space/tight_growth.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Strides between two nodes whose exact states are kept: what finding a state takes at most.
constexpr std::uint8_t kStridesBetweenKeyframes = 32;
/// A round plays this many ticks of each walk: short enough for chains to be hardly longer than need be, long
/// enough for a tile to be worth the work of coming to it.
constexpr std::uint32_t kTicksOfRound = 600;
/// Likewise on the way to a goal, where what a round explores too much is wasted.
constexpr std::uint32_t kTicksOfGoalRound = 30;
/// From this height on a fall is steered up to three fifths of a second later, metres: see steered_strides.
constexpr double kHighFall = 2.0;
/// So many falls are steered before what they lead to becomes nodes.
constexpr std::size_t kFallsAtOnce = 64;

class Exploration {
public:
    Exploration(const WorkerWorlds& worlds, const ExploreSettings& settings)
        : worlds_(worlds), settings_(settings), order_(settings), space_(WalkGrid{cell_for(settings)}) {
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            workers_.emplace_back(worlds[i], settings, space_, known_);
        }
    }

    WalkSpace run() {
        add_starts();
        note_goal();
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

    /// Two pockets of free space in one cell would be taken for one if a wall fitted between them.
    static double cell_for(const ExploreSettings& settings) {
        if (settings.known != nullptr) {
            return settings.known->grid.cell;
        }
        if (settings.keep_cell) {
            return settings.cell;
        }
        const double widest = 0.99 * kDiagonal * 2.0 * settings.strides.body.radius;
        return std::min(settings.cell, widest);
    }

    void add_starts() {
        for (std::size_t i = 0; i < settings_.starts.size(); ++i) {
            const StrideEnd end = workers_.front().strider().put_down(settings_.starts[i]);
            if (end.kind == StrideEnd::Kind::grounded) {
                space_.starts.push_back(add_start(end.at));
                space_.start_of.push_back(i);
            }
        }
        for (const GroundState& at : settings_.more_starts) {
            add_start(at);
        }
    }

    WalkNodeId add_start(const GroundState& at) {
        const GridCell cell = space_.grid.cell_at(at.foot);
        if (const auto known = space_.find(cell, at.foot.y())) {
            return *known;
        }
        const std::uint32_t tile = tile_for(cell);
        WalkNode node;
        node.y = static_cast<float>(at.foot.y());
        node.cell = space_.tiles[tile].index_of(cell) & 255U;
        node.parent_tile = WalkNode::kStart;
        node.returns = 1;
        node.low = workers_.front().strider().has_headroom(at) ? 0 : 1;
        return {tile, *add_node(tile, node, at, 0, kStridesBetweenKeyframes)};
    }

    /// Without steering in falls.
    void explore_ground() {
        const std::uint32_t round = order_.has_goal() ? kTicksOfGoalRound : kTicksOfRound;
        std::uint32_t limit = 0;
        while (const auto earliest = space_.goal ? std::nullopt : earliest_pending()) {
            if (*earliest >= settings_.max_ticks) {
                break;
            }
            limit = std::min(std::max(limit, *earliest) + round, settings_.max_ticks);
            explore_tiles(limit);
            note_goal();
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
            for (const SteeredEnd& each : ends[i]) {
                note(tile, fall.from(), each.stride, each.end, workers_.front());
            }
            tiles.push_back(tile);
        }
        receive_from(tiles);
        note_goal();
    }

    std::uint32_t tile_for(const GridCell& cell) {
        const std::uint32_t tile = space_.add_tile_at(cell);
        frontiers_.resize(space_.tiles.size());
        return tile;
    }

    void note_goal() {
        for (std::uint32_t i = 0; i < frontiers_.size() && !space_.goal; ++i) {
            if (frontiers_[i].goal) {
                space_.goal = WalkNodeId{i, *frontiers_[i].goal};
            }
        }
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
            explore_tile(tile, limit, workers_[worker]);
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
                receive(tile, arrival, worker);
            }
        }
    }

    /// What is already received makes no difference.
    void receive_from(const std::vector<std::uint32_t>& tiles) {
        for (const std::uint32_t tile : tiles) {
            for (const Arrival& arrival : std::exchange(frontiers_[tile].outbox, {})) {
                receive(tile_for(arrival.cell), arrival, workers_.front());
            }
        }
    }

    /// By one worker; others work on tiles farther away.
    void explore_tile(std::uint32_t tile, std::uint32_t limit, StrideWorker& worker) {
        // Its strides may add tiles only once they are received, so that the frontier stays where it is.
        Frontier& frontier = frontiers_[tile];
        while (!frontier.is_empty() && frontier.next_order() < limit && !frontier.goal) {
            const Pending next = frontier.pop();
            if (next.is_detour) {
                add_or_send(tile, frontier.detour(next.node), worker);
            } else {
                stride_from(tile, next, worker);
            }
        }
        worker.strider().forget_dense_surroundings();
    }

    void stride_from(std::uint32_t tile, Pending from, StrideWorker& worker) {
        if (from.next == Pending::Strides::jumps) {
            jump_from(tile, from, worker);
            return;
        }
        const GridCell cell = space_.grid.cell_at(from.at.foot);
        const std::uint8_t first = from.next == Pending::Strides::diagonal ? 4 : 0;
        for (std::uint8_t i = first; i < first + 4; ++i) {
            const GridDirection& direction = grid_directions()[i];
            const GridCell goal{cell.x + direction.x, cell.z + direction.z};
            if (worker.is_known(tile, from.at, i)) {
                from.jumps_later |= bit_of(i);
                continue;
            }
            const StrideEnd end = try_stride(tile, from, {.direction = i}, worker);
            from.on_rim = from.on_rim || end.left_ground || space_.grid.cell_at(end.at.foot) != goal;
            if (settings_.run && end.left_ground) {
                try_stride(tile, from, {.direction = i, .gait = Gait::run}, worker);
            }
            if (settings_.jump && !end.clean) {
                try_stride(tile, from, {.direction = i, .gait = Gait::jump}, worker);
            } else {
                from.jumps_later |= bit_of(i);
            }
        }
        if (from.next == Pending::Strides::along_axes) {
            from.next = Pending::Strides::diagonal;
            from.order += order_.diagonals_later();
            frontiers_[tile].push(from);
            return;
        }
        if (from.on_rim && settings_.keep_rim) {
            space_.tiles[tile].rim.push_back({from.node, from.at});
        }
        if (settings_.jump && from.jumps_later != 0) {
            from.next = Pending::Strides::jumps;
            from.order += order_.jumps_later();
            frontiers_[tile].push(from);
        }
    }

    static std::uint8_t bit_of(std::uint8_t direction) { return static_cast<std::uint8_t>(1U << direction); }

    /// Onto what lies ahead, over clear ground: what is high is got onto at the height of a jump. Those out
    /// of the world don't count: they lead over an edge that is nearer to other nodes.
    void jump_from(std::uint32_t tile, const Pending& from, StrideWorker& worker) {
        for (std::uint8_t i = 0; i < 8; ++i) {
            if ((from.jumps_later & bit_of(i)) == 0 || !worker.may_jump_up(tile, from.at, i)) {
                continue;
            }
            const Stride jump{.direction = i, .gait = Gait::jump};
            const StrideEnd end = worker.take(tile, from.at, jump);
            if (end.kind != StrideEnd::Kind::gone) {
                note(tile, from, jump, end, worker);
            }
        }
    }

    StrideEnd try_stride(std::uint32_t tile, const Pending& from, const Stride& stride,
                         StrideWorker& worker) {
        StrideEnd end = worker.take(tile, from.at, stride);
        note(tile, from, stride, end, worker);
        const bool gone = end.kind == StrideEnd::Kind::gone;
        const double height = end.edge.y() - end.at.foot.y();
        if (end.left_ground && (gone || height >= kSteeredFall)) {
            frontiers_[tile].keep({.at = from.at,
                                   .ticks = from.ticks,
                                   .edge = end.edge.cast<float>(),
                                   .node = from.node,
                                   .since_keyframe = from.since_keyframe,
                                   .direction = stride.direction,
                                   .gait = stride.gait,
                                   .high = gone || height >= kHighFall,
                                   .gone = gone},
                                  space_.grid.cell_at(end.edge));
        }
        return end;
    }

    void note(std::uint32_t tile, const Pending& from, const Stride& stride, const StrideEnd& end,
              StrideWorker& worker) {
        if (end.given_up) {
            return;
        }
        if (end.kind == StrideEnd::Kind::grounded) {
            arrive(tile, from, stride, end, worker);
        } else if (end.kind == StrideEnd::Kind::gone) {
            note_drop(tile, {from.node, stride, end.edge});
        } else {
            worker.bounds.insert(Bound::falls);
        }
    }

    static FallEdge edge_of(const Fall& fall) { return {fall.edge.cast<double>(), fall.gait}; }

    void note_drop(std::uint32_t tile, const WalkTile::Drop& drop) {
        WalkTile& own = space_.tiles[tile];
        const bool steered = drop.stride.steering != Stride::kStraightOn;  // it leaves the same edge
        if (!steered && !own.has_drop_from(drop.edge, space_.grid)) {
            push_tightly(own.drops, drop);
        }
    }

    bool is_out(const Vec3& foot) const {
        return (!settings_.within.empty() && !settings_.within.overlaps({foot, foot})) ||
               (settings_.keep_out && settings_.keep_out(foot));
    }

    bool is_goal(const GridCell& cell, const GroundState& at) const {
        return (settings_.is_goal && settings_.is_goal(cell, at.foot.y())) ||
               (settings_.is_goal_state && settings_.is_goal_state(at));
    }

    void arrive(std::uint32_t tile, const Pending& from, const Stride& stride, const StrideEnd& end,
                StrideWorker& worker) {
        const GridCell cell = space_.grid.cell_at(end.at.foot);
        if (is_out(end.at.foot) || settings_.knows(cell, end.at.foot.y())) {
            return;
        }
        const bool hangs = worker.strider().hangs(end.at);
        const WalkTile& own = space_.tiles[tile];
        if (own.contains(cell)
                ? own.has(own.index_of(cell), end.at.foot.y(), hangs)
                : !settings_.towards && frontiers_[tile].has_sent(cell, end.at.foot.y(), hangs)) {
            return;
        }
        const std::uint32_t detour = order_.ticks_for_detour(end);
        const Arrival arrival{from.ticks + static_cast<std::uint32_t>(end.ticks) + detour,
                              {tile, from.node},
                              stride,
                              end.clean || (!settings_.towards && worker.returns(end, from.at)),
                              hangs,
                              static_cast<std::uint8_t>(from.since_keyframe + 1),
                              cell,
                              end.at};
        if (detour == 0 ||
            !frontiers_[tile].push_detour(arrival, arrival.ticks + order_.ticks_to_goal(end.at.foot))) {
            add_or_send(tile, arrival, worker);
        }
    }

    void add_or_send(std::uint32_t tile, const Arrival& arrival, StrideWorker& worker) {
        if (!space_.tiles[tile].contains(arrival.cell)) {
            frontiers_[tile].outbox.push_back(arrival);
        } else if (const WalkTile& own = space_.tiles[tile];
                   !own.has(own.index_of(arrival.cell), arrival.at.foot.y(), arrival.hangs)) {
            add_arrival(tile, WalkNode{}, arrival, worker);
        }
    }

    /// Of a stride out of its tile.
    void receive(std::uint32_t tile, const Arrival& arrival, StrideWorker& worker) {
        WalkTile& own = space_.tiles[tile];
        if (own.has(own.index_of(arrival.cell), arrival.at.foot.y(), arrival.hangs)) {
            return;
        }
        WalkNode node;
        const auto beside = std::ranges::find(own.neighbours, arrival.parent.tile);
        node.parent_tile = beside == own.neighbours.end()
                               ? WalkNode::kFarParent
                               : static_cast<std::uint32_t>(beside - own.neighbours.begin()) & 15U;
        if (node.parent_tile == WalkNode::kFarParent) {
            own.far_parents.push_back({static_cast<std::uint16_t>(own.nodes.size()), arrival.parent.tile});
        }
        add_arrival(tile, node, arrival, worker);
    }

    void add_arrival(std::uint32_t tile, WalkNode node, const Arrival& arrival, StrideWorker& worker) {
        if (arrival.parent.tile == tile) {
            node.parent_tile = 4;
        }
        node.y = static_cast<float>(arrival.at.foot.y());
        node.cell = space_.tiles[tile].index_of(arrival.cell) & 255U;
        node.parent = arrival.parent.node;
        node.direction = arrival.stride.direction & 7U;
        node.gait = static_cast<std::uint32_t>(arrival.stride.gait) & 3U;
        node.steering = arrival.stride.steering & 15U;
        node.steers_after = arrival.stride.steers_after & 7U;
        node.returns = arrival.returns ? 1 : 0;
        node.hangs = arrival.hangs ? 1 : 0;
        node.low = worker.strider().has_headroom(arrival.at) ? 0 : 1;
        if (!add_node(tile, node, arrival.at, arrival.ticks, arrival.since_keyframe)) {
            worker.bounds.insert(Bound::levels);
        }
    }

    /// None if the tile is full.
    std::optional<std::uint16_t> add_node(std::uint32_t tile, const WalkNode& node, const GroundState& at,
                                          std::uint32_t ticks, std::uint8_t since_keyframe) {
        WalkTile& own = space_.tiles[tile];
        if (own.nodes.size() >= WalkTile::kMaxNodes) {
            return std::nullopt;
        }
        const std::uint16_t number = own.add(node);
        if (!frontiers_[tile].goal && is_goal(own.cell_of(node), at)) {
            frontiers_[tile].goal = number;
        }
        const bool keep = since_keyframe >= kStridesBetweenKeyframes;
        if (keep) {
            push_tightly(own.keyframes, {number, at});
        }
        frontiers_[tile].push({.order = ticks + order_.ticks_to_goal(at.foot),
                               .ticks = ticks,
                               .node = number,
                               .since_keyframe = keep ? std::uint8_t{0} : since_keyframe,
                               .at = at});
        return number;
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
    const PathOrder order_;
    WalkSpace space_;
    std::vector<Frontier> frontiers_;  ///< by tile
    const KnownCells known_{settings_, space_, frontiers_};
    std::vector<StrideWorker> workers_;
    bool is_cut_ = false;  ///< by the most nodes
};

}  // namespace

WalkSpace explore(const WorkerWorlds& worlds, const ExploreSettings& settings) {
    return Exploration(worlds, settings).run();
}

}  // namespace campuswalk::engine
