#include "engine/walkspace/explore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "engine/walkspace/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Strides between two nodes whose exact states are kept: what finding a state takes at most.
constexpr std::uint8_t kStridesBetweenKeyframes = 32;
/// A round plays this many ticks of each walk: short enough for chains to be hardly longer than need be, long
/// enough for a tile to be worth the work of coming to it.
constexpr std::uint32_t kTicksOfRound = 600;
/// Likewise on the way to a point, where what a round explores too much is wasted.
constexpr std::uint32_t kTicksOfGoalRound = 30;
/// From this height on a fall is also steered elsewhere, metres.
constexpr double kSteeredFall = 0.5;

/// From this height on it is also steered later, metres: what is below an edge is often set back, and a body
/// that steers back at once lands on the edge again.
constexpr double kHighFall = 2.0;
/// Fifths of a second; a fall of 5 m takes one second.
constexpr std::uint8_t kLatestSteering = 3;

/// Nodes take the strides across their cell's corners this much later, metres of walking: somewhat more than
/// the 0.1 m that they are longer, so that nearly all cells are reached by the shorter strides.
constexpr double kMetresLaterAcross = 0.19;

/// A node whose strides are yet to be taken.
struct Pending {
    std::uint32_t order = 0;  ///< ticks, and those to the goal, if there is one
    std::uint32_t ticks = 0;  ///< of its chain
    std::uint16_t node = 0;
    std::uint8_t since_keyframe = 0;
    bool across_corners = false;  ///< only the strides across the cell's corners are left
    bool on_rim = false;          ///< one of the others didn't get to its cell
    GroundState at;
};

/// The earlier first, at the top of a heap.
bool later(const Pending& a, const Pending& b) {
    return std::tie(a.order, a.ticks, a.node) > std::tie(b.order, b.ticks, b.node);
}

void push(std::vector<Pending>& pending, const Pending& node) {
    pending.push_back(node);
    std::ranges::push_heap(pending, later);
}

/// What a stride leads to outside of its tile.
struct Arrival {
    std::uint32_t ticks = 0;
    WalkNodeId parent;
    Stride stride;
    bool returns = false;
    std::uint8_t since_keyframe = 0;
    GroundState at;
};

/// What a tile needs while it is explored.
struct Frontier {
    std::vector<Pending> pending;  ///< a heap
    std::vector<Arrival> outbox;
    std::optional<std::uint16_t> goal;                   ///< the first node that is one
    std::vector<std::pair<GridCell, float>> steered_at;  ///< edges from which falls were steered
};

/// A thread's body and what it found.
struct Worker {
    Strider strider;
    std::set<Bound> bounds = {};
    std::uint64_t strides = 0;
};

class Exploration {
public:
    Exploration(const WorkerWorlds& worlds, const ExploreSettings& settings)
        : settings_(settings), space_(WalkGrid{cell_for(settings)}) {
        if (!settings_.towards) {  // the way to a point is worth the longer stride
            later_across_corners_ = ticks_in(kMetresLaterAcross / settings_.strides.walk_speed);
        }
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            workers_.push_back({Strider(worlds[i], settings.strides, settings.solids)});
        }
    }

    WalkSpace run() {
        add_starts();
        note_goal();
        const std::uint32_t round = settings_.towards ? kTicksOfGoalRound : kTicksOfRound;
        std::uint32_t limit = 0;
        while (const auto earliest = space_.goal ? std::nullopt : earliest_pending()) {
            limit = std::max(limit + round, *earliest + round);
            // Tiles side by side are never explored at once: each looks at its neighbours' nodes.
            for (std::size_t color = 0; color < 4; ++color) {
                explore_tiles(color, limit);
            }
            note_goal();
            const std::size_t nodes = space_.node_count();
            if (nodes > settings_.max_nodes) {
                workers_.front().bounds.insert(Bound::nodes);
                break;
            }
            if (settings_.progress) {
                settings_.progress(nodes);
            }
        }
        return finished();
    }

private:
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
            const StrideEnd end = workers_.front().strider.put_down(settings_.starts[i]);
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
        node.cell = space_.tiles[tile].index_of(cell) & 1023U;
        node.parent_tile = WalkNode::kStart;
        node.returns = 1;
        return {tile, *add_node(tile, node, at, 0, kStridesBetweenKeyframes)};
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
            if (!frontier.pending.empty()) {
                const std::uint32_t order = frontier.pending.front().order;
                earliest = std::min(earliest.value_or(order), order);
            }
        }
        return earliest;
    }

    static std::size_t color_of(const WalkTile& tile) {
        const auto parity = [](int first_cell) {
            return static_cast<std::size_t>((first_cell / WalkTile::kCells) & 1);
        };
        return parity(tile.first_cell.x) + 2 * parity(tile.first_cell.z);
    }

    void explore_tiles(std::size_t color, std::uint32_t limit) {
        std::vector<std::uint32_t> active;
        for (std::uint32_t i = 0; i < frontiers_.size(); ++i) {
            const std::vector<Pending>& pending = frontiers_[i].pending;
            if (!pending.empty() && pending.front().order < limit && color_of(space_.tiles[i]) == color) {
                active.push_back(i);
            }
        }
        for_each_item(active.size(), workers_.size(), [&](std::size_t worker, std::size_t item) {
            explore_tile(active[item], limit, workers_[worker]);
        });
        for (const std::uint32_t tile : active) {
            std::vector<Arrival> arrivals = std::exchange(frontiers_[tile].outbox, {});
            for (const Arrival& arrival : arrivals) {
                receive(arrival);
            }
        }
    }

    /// By one worker; others work on tiles farther away.
    void explore_tile(std::uint32_t tile, std::uint32_t limit, Worker& worker) {
        std::vector<Pending>& pending = frontiers_[tile].pending;
        while (!pending.empty() && pending.front().order < limit && !frontiers_[tile].goal) {
            std::ranges::pop_heap(pending, later);
            const Pending next = pending.back();
            pending.pop_back();
            stride_from(tile, next, worker);
        }
    }

    void stride_from(std::uint32_t tile, Pending from, Worker& worker) {
        const GridCell cell = space_.grid.cell_at(from.at.foot);
        const std::uint8_t first = from.across_corners ? 4 : 0;
        for (std::uint8_t i = first; i < first + 4; ++i) {
            const GridDirection& direction = grid_directions()[i];
            const GridCell goal{cell.x + direction.x, cell.z + direction.z};
            if (is_known(goal, from.at, tile, worker)) {
                continue;
            }
            const StrideEnd end = try_stride(tile, from, {.direction = i}, worker);
            from.on_rim = from.on_rim || end.left_ground || space_.grid.cell_at(end.at.foot) != goal;
            const bool stopped =
                end.kind == StrideEnd::Kind::grounded && space_.grid.cell_at(end.at.foot) == cell;
            if (settings_.run && end.left_ground) {
                try_stride(tile, from, {.direction = i, .gait = Gait::run}, worker);
            }
            if (settings_.jump && (end.left_ground || stopped)) {
                try_stride(tile, from, {.direction = i, .gait = Gait::jump}, worker);
            }
        }
        if (!from.across_corners) {
            from.across_corners = true;
            from.order += later_across_corners_;
            push(frontiers_[tile].pending, from);
        } else if (from.on_rim && settings_.keep_rim) {
            space_.tiles[tile].rim.push_back({from.node, from.at});
        }
    }

    /// Whether the cell has a node at this height; it is in the tile or beside it.
    bool is_known(const GridCell& cell, const GroundState& from, std::uint32_t tile,
                  const Worker& worker) const {
        const double y = from.foot.y();
        if (settings_.known != nullptr && settings_.known->find(cell, y)) {
            return true;
        }
        const WalkTile& own = space_.tiles[tile];
        const auto side = [](int at, int first_cell) {
            return at < first_cell ? 0 : at >= first_cell + WalkTile::kCells ? 2 : 1;
        };
        const int beside = side(cell.x, own.first_cell.x) + 3 * side(cell.z, own.first_cell.z);
        const std::uint32_t number = own.neighbours[static_cast<std::size_t>(beside)];
        if (number == WalkTile::kNoTile) {
            return false;
        }
        const WalkTile& other = space_.tiles[number];
        return other.has(other.index_of(cell), y, worker.strider.hangs(from));
    }

    StrideEnd try_stride(std::uint32_t tile, const Pending& from, const Stride& stride, Worker& worker) {
        const StrideEnd end = take(tile, from, stride, worker);
        const bool gone = end.kind == StrideEnd::Kind::gone;
        if (end.left_ground && stride.steering == Stride::kStraightOn &&
            (gone || end.edge.y() - end.at.foot.y() >= kSteeredFall)) {
            steer(tile, from, stride, end, worker);
        }
        return end;
    }

    StrideEnd take(std::uint32_t tile, const Pending& from, const Stride& stride, Worker& worker) {
        const StrideEnd end = worker.strider.take(from.at, stride, space_.grid);
        ++worker.strides;
        if (end.kind == StrideEnd::Kind::grounded) {
            arrive(tile, from, stride, end, worker);
        } else if (end.kind == StrideEnd::Kind::gone) {
            // Once for an edge, not for each time of steering.
            if (stride.steers_after == 0) {
                space_.tiles[tile].drops.push_back({from.node, stride, end.edge});
            }
        } else {
            worker.bounds.insert(Bound::falls);
        }
        return end;
    }

    /// The same fall, steered elsewhere; once for each cell and height of an edge.
    void steer(std::uint32_t tile, const Pending& from, const Stride& stride, const StrideEnd& straight,
               Worker& worker) {
        const GridCell cell = space_.grid.cell_at(straight.edge);
        const auto height = static_cast<float>(straight.edge.y());
        auto& known = frontiers_[tile].steered_at;
        const bool steered = std::ranges::any_of(known, [&](const auto& edge) {
            return edge.first == cell && std::abs(edge.second - height) <= WalkNode::kLevel;
        });
        if (steered) {
            return;
        }
        known.emplace_back(cell, height);
        if (straight.kind == StrideEnd::Kind::gone &&
            !worker.strider.has_ground_below(straight.edge, stride.gait)) {
            return;
        }
        worker.bounds.insert(Bound::steering);
        Stride other = stride;
        other.steering = Stride::kLetGo;
        const StrideEnd down = take(tile, from, other, worker);
        const bool gone = straight.kind == StrideEnd::Kind::gone;
        const bool over_the_rim = gone && down.kind == StrideEnd::Kind::gone;
        const bool high = gone || straight.edge.y() - straight.at.foot.y() >= kHighFall;
        const Vec3& ahead = grid_directions()[stride.direction].unit;
        for (std::uint8_t after = over_the_rim ? 1 : 0; after <= (high ? kLatestSteering : 0); ++after) {
            other.steers_after = after;
            for (std::uint8_t i = 0; i < 8; ++i) {
                // Over the rim of the world, ground can only be behind.
                if (i != stride.direction && (!over_the_rim || grid_directions()[i].unit.dot(ahead) < -0.1)) {
                    other.steering = i;
                    take(tile, from, other, worker);
                }
            }
            if (after > 0 && !over_the_rim) {
                other.steering = Stride::kLetGo;
                take(tile, from, other, worker);
            }
        }
    }

    bool is_out(const Vec3& foot) const {
        return (!settings_.within.empty() && !settings_.within.overlaps({foot, foot})) ||
               (settings_.keep_out && settings_.keep_out(foot));
    }

    /// Of an arrival, for its place in the order.
    std::uint32_t ticks_of(const StrideEnd& end) const {
        const double fall =
            settings_.towards && end.left_ground ? end.edge.y() - end.at.foot.y() - kHarmlessFall : 0.0;
        return static_cast<std::uint32_t>(end.ticks) +
               (fall > 0.0 ? ticks_in(fall * kSecondsRoundAFall) : 0U);
    }

    /// As the strides go: along the axes and diagonals.
    std::uint32_t ticks_to_goal(const Vec3& foot) const {
        if (!settings_.towards) {
            return 0;
        }
        const Vec3 apart = (*settings_.towards - foot).cwiseAbs();
        const double less = std::min(apart.x(), apart.z());
        const double more = std::max(apart.x(), apart.z());
        return ticks_in((more - less + less / kDiagonal) / settings_.strides.walk_speed);
    }

    std::uint32_t ticks_in(double seconds) const {
        constexpr double kMost = 1e9;
        return static_cast<std::uint32_t>(std::min(kMost, seconds / settings_.strides.seconds));
    }

    bool is_goal(const GridCell& cell, const GroundState& at) const {
        return (settings_.is_goal && settings_.is_goal(cell, at.foot.y())) ||
               (settings_.is_goal_state && settings_.is_goal_state(at));
    }

    void arrive(std::uint32_t tile, const Pending& from, const Stride& stride, const StrideEnd& end,
                Worker& worker) {
        const GridCell cell = space_.grid.cell_at(end.at.foot);
        if (is_out(end.at.foot) ||
            (settings_.known != nullptr && settings_.known->find(cell, end.at.foot.y()))) {
            return;
        }
        WalkTile& own = space_.tiles[tile];
        const bool inside = cell.x >= own.first_cell.x && cell.x < own.first_cell.x + WalkTile::kCells &&
                            cell.z >= own.first_cell.z && cell.z < own.first_cell.z + WalkTile::kCells;
        if (inside && own.has(own.index_of(cell), end.at.foot.y(), worker.strider.hangs(end.at))) {
            return;
        }
        const Arrival arrival{from.ticks + ticks_of(end),
                              {tile, from.node},
                              stride,
                              end.clean || (!settings_.towards && returns(end.at, from, worker)),
                              static_cast<std::uint8_t>(from.since_keyframe + 1),
                              end.at};
        if (inside) {
            add_arrival(tile, WalkNode{}, cell, arrival, worker);
        } else {
            frontiers_[tile].outbox.push_back(arrival);
        }
    }

    /// Whether one can walk back from there.
    bool returns(const GroundState& at, const Pending& to, Worker& worker) {
        const Vec3 path = to.at.foot - at.foot;
        const double seconds = 2.0 * collision::horizontal_norm(path) / settings_.strides.walk_speed + 0.2;
        const StrideEnd back = worker.strider.walk_to(at, to.at.foot, 0.02, seconds);
        return back.kind == StrideEnd::Kind::grounded &&
               space_.grid.cell_at(back.at.foot) == space_.grid.cell_at(to.at.foot) &&
               std::abs(back.at.foot.y() - to.at.foot.y()) <= WalkNode::kLevel;
    }

    /// Of a stride out of its tile; one at a time.
    void receive(const Arrival& arrival) {
        const GridCell cell = space_.grid.cell_at(arrival.at.foot);
        const std::uint32_t tile = tile_for(cell);
        WalkTile& own = space_.tiles[tile];
        if (own.has(own.index_of(cell), arrival.at.foot.y(), workers_.front().strider.hangs(arrival.at))) {
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
        add_arrival(tile, node, cell, arrival, workers_.front());
    }

    void add_arrival(std::uint32_t tile, WalkNode node, const GridCell& cell, const Arrival& arrival,
                     Worker& worker) {
        if (arrival.parent.tile == tile) {
            node.parent_tile = 4;
        }
        node.y = static_cast<float>(arrival.at.foot.y());
        node.cell = space_.tiles[tile].index_of(cell) & 1023U;
        node.parent = arrival.parent.node;
        node.direction = arrival.stride.direction & 7U;
        node.gait = static_cast<std::uint32_t>(arrival.stride.gait) & 3U;
        node.steering = arrival.stride.steering & 15U;
        node.steers_after = arrival.stride.steers_after & 7U;
        node.returns = arrival.returns ? 1 : 0;
        node.hangs = worker.strider.hangs(arrival.at) ? 1 : 0;
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
            own.keyframes.push_back({number, at});
        }
        push(frontiers_[tile].pending, {.order = ticks + ticks_to_goal(at.foot),
                                        .ticks = ticks,
                                        .node = number,
                                        .since_keyframe = keep ? std::uint8_t{0} : since_keyframe,
                                        .at = at});
        return number;
    }

    WalkSpace finished() {
        std::set<Bound> bounds;
        space_.touched.assign(workers_.front().strider.touched().size(), false);
        for (const Worker& worker : workers_) {
            bounds.insert(worker.bounds.begin(), worker.bounds.end());
            space_.ticks += worker.strider.ticks();
            space_.strides += worker.strides;
            for (std::size_t i = 0; i < space_.touched.size(); ++i) {
                space_.touched[i] = space_.touched[i] || worker.strider.touched()[i];
            }
        }
        space_.bounds.assign(bounds.begin(), bounds.end());
        return std::move(space_);
    }

    const ExploreSettings& settings_;
    std::uint32_t later_across_corners_ = 0;  ///< ticks
    WalkSpace space_;
    std::vector<Worker> workers_;
    std::vector<Frontier> frontiers_;  ///< by tile
};

}  // namespace

WalkSpace explore(const WorkerWorlds& worlds, const ExploreSettings& settings) {
    return Exploration(worlds, settings).run();
}

}  // namespace campuswalk::engine
