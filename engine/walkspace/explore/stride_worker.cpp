#include "engine/walkspace/explore/stride_worker.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::engine {

using collision::Vec3;

StrideWorker::StrideWorker(const collision::World& world, const ExploreSettings& settings,
                           const WalkSpace& space, const KnownCells& known)
    : settings_(settings), space_(space), known_(known), strider_(world, settings.strides, settings.solids) {
    if (!settings.within.empty()) {
        strider_.limit_falls(settings.within);
    }
}

bool StrideWorker::is_known(std::uint32_t tile, const GroundState& from, std::uint8_t direction) const {
    const GridDirection& to = grid_directions()[direction];
    const GridCell cell = space_.grid.cell_at(from.foot);
    const GridCell ahead{cell.x + to.x, cell.z + to.z};
    const GridCell behind{cell.x - to.x, cell.z - to.z};
    const double y = from.foot.y();
    const bool hangs = strider_.hangs(from);
    return known_.has(ahead, y, hangs, tile) || (!hangs && known_.has_ahead(ahead, behind, y, tile));
}

bool StrideWorker::may_jump_up(std::uint32_t tile, const GroundState& from, std::uint8_t direction) {
    const StrideSettings& strides = settings_.strides;
    const double length = jump_length(strides);
    // What carries a body may be as high as its middle, beside which its foot hangs.
    const double low = strides.body.step_height;
    const double high = jump_height(strides) + strides.body.radius;
    const auto lowest = known_.ground_ahead(from.foot, direction, length, tile);
    if (lowest && *lowest + strides.body.height >= from.foot.y() + high) {
        return false;  // whatever is above the ground there is too high
    }
    const Vec3 start = from.foot + Vec3(0.0, 0.5 * (low + high), 0.0);
    const Vec3 end = start + length * grid_directions()[direction].unit;
    collision::gather_obstacles(strider_.world(), strider_.filter(), {start, end},
                                std::max(0.5 * (high - low), strides.body.radius), ahead_);
    return std::ranges::any_of(ahead_, [&](const collision::Obstacle& piece) {
        const bool walkable = piece.solid == nullptr && std::abs(piece.normal.y()) >= strides.body.min_up;
        return piece.top > from.foot.y() + low && (walkable || piece.top <= from.foot.y() + high);
    });
}

StrideEnd StrideWorker::take(std::uint32_t tile, const GroundState& from, const Stride& stride) {
    ++strides_;
    // Whoever may jump gets away from what he stands against.
    const auto is_worth_it = [&](const GroundState& at, double metres) {
        return settings_.jump || !known_.has_all_near(at.foot, metres, strider_.hangs(at), tile);
    };
    return strider_.take(from, stride, space_.grid, is_worth_it);
}

std::vector<SteeredEnd> StrideWorker::steer(std::uint32_t tile, const Fall& fall) {
    strider_.forget_last_stride();  // which of the threads took it must make no difference
    std::vector<SteeredEnd> ends;
    const auto try_stride = [&](const Stride& stride) {
        const StrideEnd end = take(tile, fall.at, stride);
        if (!is_at_node(end)) {
            ends.push_back({stride, end});
        }
        return end.kind;
    };
    Stride straight_down = fall.stride();
    straight_down.steering = Stride::kLetGo;
    const bool gone = try_stride(straight_down) == StrideEnd::Kind::gone;
    for (const Stride& stride : steered_strides(fall, fall.gone && gone)) {
        try_stride(stride);
    }
    return ends;
}

bool StrideWorker::returns(const StrideEnd& end, const GroundState& start) {
    const GroundState& at = end.at;
    if (end.left_ground && end.edge.y() - at.foot.y() >= kSteeredFall) {
        return false;
    }
    const Vec3 path = start.foot - at.foot;
    const double seconds = 2.0 * collision::horizontal_norm(path) / settings_.strides.walk_speed + 0.2;
    const StrideEnd back = strider_.walk_to(at, start.foot, 0.02, seconds);
    return back.kind == StrideEnd::Kind::grounded &&
           space_.grid.cell_at(back.at.foot) == space_.grid.cell_at(start.foot) &&
           std::abs(back.at.foot.y() - start.foot.y()) <= WalkNode::kLevel;
}

bool StrideWorker::is_at_node(const StrideEnd& end) const {
    if (end.kind != StrideEnd::Kind::grounded) {
        return false;
    }
    const GridCell cell = space_.grid.cell_at(end.at.foot);
    const auto tile = space_.tile_at(cell);
    return tile && space_.tiles[*tile].has(space_.tiles[*tile].index_of(cell), end.at.foot.y(),
                                           strider_.hangs(end.at));
}

}  // namespace campuswalk::engine
