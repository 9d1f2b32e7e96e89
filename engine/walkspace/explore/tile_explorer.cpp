#include "engine/walkspace/explore/tile_explorer.h"

namespace campuswalk::engine {

namespace {

/// From this height on a fall is steered up to three fifths of a second later, metres: see steered_strides.
constexpr double kHighFall = 2.0;

std::uint8_t bit_of(std::uint8_t direction) {
    return static_cast<std::uint8_t>(1U << direction);
}

}  // namespace

void TileExplorer::explore(std::uint32_t limit) {
    // Its strides may add tiles only once they are received, so that the frontier stays where it is.
    Frontier& frontier = growing_.frontiers[tile_];
    while (!frontier.is_empty() && frontier.next_order() < limit && !frontier.goal) {
        const Pending next = frontier.pop();
        if (next.is_detour) {
            growing_.add_or_send(tile_, frontier.detour(next.node), worker_);
        } else {
            stride_from(next);
        }
    }
    worker_.strider().forget_dense_surroundings();
}

void TileExplorer::note(const Pending& from, const Stride& stride, const StrideEnd& end) {
    if (end.given_up) {
        return;
    }
    if (end.kind == StrideEnd::Kind::grounded) {
        growing_.arrive(tile_, from, stride, end, worker_);
    } else if (end.kind == StrideEnd::Kind::gone) {
        growing_.note_drop(tile_, {from.node, stride, end.edge});
    } else {
        worker_.bounds.insert(Bound::falls);
    }
}

void TileExplorer::stride_from(Pending from) {
    if (from.next == Pending::Strides::jumps) {
        jump_from(from);
        return;
    }
    const GridCell cell = growing_.space.grid.cell_at(from.at.foot);
    const std::uint8_t first = from.next == Pending::Strides::diagonal ? 4 : 0;
    for (std::uint8_t i = first; i < first + 4; ++i) {
        const GridDirection& direction = grid_directions()[i];
        const GridCell goal{cell.x + direction.x, cell.z + direction.z};
        if (worker_.is_known(tile_, from.at, i)) {
            from.jumps_later |= bit_of(i);
            continue;
        }
        const StrideEnd end = try_stride(from, {.direction = i});
        from.on_rim = from.on_rim || end.left_ground || growing_.space.grid.cell_at(end.at.foot) != goal;
        if (settings_.run && end.left_ground) {
            try_stride(from, {.direction = i, .gait = Gait::run});
        }
        if (settings_.jump && !end.clean) {
            try_stride(from, {.direction = i, .gait = Gait::jump});
        } else {
            from.jumps_later |= bit_of(i);
        }
    }
    if (from.next == Pending::Strides::along_axes) {
        from.next = Pending::Strides::diagonal;
        from.order += growing_.policy().diagonals_later();
        growing_.frontiers[tile_].push(from);
        return;
    }
    if (from.on_rim && settings_.keep_rim) {
        growing_.space.tiles[tile_].rim.push_back({from.node, from.at});
    }
    if (settings_.jump && from.jumps_later != 0) {
        from.next = Pending::Strides::jumps;
        from.order += growing_.policy().jumps_later();
        growing_.frontiers[tile_].push(from);
    }
}

StrideEnd TileExplorer::try_stride(const Pending& from, const Stride& stride) {
    StrideEnd end = worker_.take(tile_, from.at, stride);
    note(from, stride, end);
    const bool gone = end.kind == StrideEnd::Kind::gone;
    const double height = end.edge.y() - end.at.foot.y();
    if (end.left_ground && (gone || height >= kSteeredFall)) {
        growing_.frontiers[tile_].keep({.at = from.at,
                                        .ticks = from.ticks,
                                        .edge = end.edge.cast<float>(),
                                        .node = from.node,
                                        .since_keyframe = from.since_keyframe,
                                        .direction = stride.direction,
                                        .gait = stride.gait,
                                        .high = gone || height >= kHighFall,
                                        .gone = gone},
                                       growing_.space.grid.cell_at(end.edge));
    }
    return end;
}

void TileExplorer::jump_from(const Pending& from) {
    for (std::uint8_t i = 0; i < 8; ++i) {
        if ((from.jumps_later & bit_of(i)) == 0 || !worker_.may_jump_up(tile_, from.at, i)) {
            continue;
        }
        const Stride jump{.direction = i, .gait = Gait::jump};
        const StrideEnd end = worker_.take(tile_, from.at, jump);
        if (end.kind != StrideEnd::Kind::gone) {
            note(from, jump, end);
        }
    }
}

}  // namespace campuswalk::engine
