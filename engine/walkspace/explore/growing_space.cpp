#include "engine/walkspace/explore/growing_space.h"

#include <algorithm>

#include "engine/walkspace/space/tight_growth.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Strides between two nodes whose exact states are kept: what finding a state takes at most.
constexpr std::uint8_t kStridesBetweenKeyframes = 32;

/// Two pockets of free space in one cell would be taken for one if a wall fitted between them.
WalkGrid grid_for(const collision::MoverSettings& body) {
    return {std::min(WalkGrid().cell, 0.99 * kDiagonal * 2.0 * body.radius)};
}

}  // namespace

GrowingSpace::GrowingSpace(const ExploreSettings& settings, const ExploreGoal& goal)
    : space(settings.grid.value_or(grid_for(settings.strides.body))),
      settings_(settings),
      policy_(settings.strides, goal) {}

std::uint32_t GrowingSpace::tile_for(const GridCell& cell) {
    const std::uint32_t tile = space.add_tile_at(cell);
    frontiers.resize(space.tiles.size());
    return tile;
}

WalkNodeId GrowingSpace::add_start(const GroundState& at, Strider& strider) {
    const GridCell cell = space.grid.cell_at(at.foot);
    if (const auto known = space.find(cell, at.foot.y())) {
        return *known;
    }
    const std::uint32_t tile = tile_for(cell);
    WalkNode node;
    node.y = static_cast<float>(at.foot.y());
    node.cell = space.tiles[tile].index_of(cell) & 255U;
    node.parent_tile = WalkNode::kStart;
    node.returns = 1;
    node.low = strider.has_headroom(at) ? 0 : 1;
    return {tile, *add_node(tile, node, at, 0, kStridesBetweenKeyframes)};
}

void GrowingSpace::note_goal() {
    for (std::uint32_t i = 0; i < frontiers.size() && !space.goal; ++i) {
        if (frontiers[i].goal) {
            space.goal = WalkNodeId{i, *frontiers[i].goal};
        }
    }
}

void GrowingSpace::note_drop(std::uint32_t tile, const WalkTile::Drop& drop) {
    WalkTile& own = space.tiles[tile];
    const bool steered = drop.stride.steering != Stride::kStraightOn;  // it leaves the same edge
    if (!steered && !own.has_drop_from(drop.edge, space.grid)) {
        push_tightly(own.drops, drop);
    }
}

void GrowingSpace::arrive(std::uint32_t tile, const Pending& from, const Stride& stride, const StrideEnd& end,
                          StrideWorker& worker) {
    const GridCell cell = space.grid.cell_at(end.at.foot);
    if (is_out(end.at.foot) || settings_.knows(cell, end.at.foot.y())) {
        return;
    }
    const bool hangs = worker.strider().hangs(end.at);
    const WalkTile& own = space.tiles[tile];
    if (own.contains(cell)
            ? own.has(own.index_of(cell), end.at.foot.y(), hangs)
            : !policy_.leads_to_point() && frontiers[tile].has_sent(cell, end.at.foot.y(), hangs)) {
        return;
    }
    const std::uint32_t detour = policy_.ticks_for_detour(end);
    const Arrival arrival{from.ticks + static_cast<std::uint32_t>(end.ticks) + detour,
                          {tile, from.node},
                          stride,
                          end.clean || (!policy_.leads_to_point() && worker.returns(end, from.at)),
                          hangs,
                          static_cast<std::uint8_t>(from.since_keyframe + 1),
                          cell,
                          end.at};
    if (detour == 0 ||
        !frontiers[tile].push_detour(arrival, arrival.ticks + policy_.ticks_to_goal(end.at.foot))) {
        add_or_send(tile, arrival, worker);
    }
}

void GrowingSpace::add_or_send(std::uint32_t tile, const Arrival& arrival, StrideWorker& worker) {
    if (!space.tiles[tile].contains(arrival.cell)) {
        frontiers[tile].outbox.push_back(arrival);
    } else if (const WalkTile& own = space.tiles[tile];
               !own.has(own.index_of(arrival.cell), arrival.at.foot.y(), arrival.hangs)) {
        add_arrival(tile, WalkNode{}, arrival, worker);
    }
}

void GrowingSpace::receive(std::uint32_t tile, const Arrival& arrival, StrideWorker& worker) {
    WalkTile& own = space.tiles[tile];
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

bool GrowingSpace::is_out(const Vec3& foot) const {
    return (!settings_.within.empty() && !settings_.within.overlaps({foot, foot})) ||
           (settings_.keep_out && settings_.keep_out(foot));
}

void GrowingSpace::add_arrival(std::uint32_t tile, WalkNode node, const Arrival& arrival,
                               StrideWorker& worker) {
    if (arrival.parent.tile == tile) {
        node.parent_tile = 4;
    }
    node.y = static_cast<float>(arrival.at.foot.y());
    node.cell = space.tiles[tile].index_of(arrival.cell) & 255U;
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

std::optional<std::uint16_t> GrowingSpace::add_node(std::uint32_t tile, const WalkNode& node,
                                                    const GroundState& at, std::uint32_t ticks,
                                                    std::uint8_t since_keyframe) {
    WalkTile& own = space.tiles[tile];
    if (own.nodes.size() >= WalkTile::kMaxNodes) {
        return std::nullopt;
    }
    const std::uint16_t number = own.add(node);
    if (!frontiers[tile].goal && policy_.is_goal(own.cell_of(node), at)) {
        frontiers[tile].goal = number;
    }
    const bool keep = since_keyframe >= kStridesBetweenKeyframes;
    if (keep) {
        push_tightly(own.keyframes, {number, at});
    }
    frontiers[tile].push({.order = ticks + policy_.ticks_to_goal(at.foot),
                          .ticks = ticks,
                          .node = number,
                          .since_keyframe = keep ? std::uint8_t{0} : since_keyframe,
                          .at = at});
    return number;
}

}  // namespace campuswalk::engine
