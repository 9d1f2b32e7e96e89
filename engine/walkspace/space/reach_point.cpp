#include "engine/walkspace/space/reach_point.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A point this far above or below the feet is reached, metres; see the step walk_to.
constexpr double kLevelOfPoint = 0.5;

/// In the point's cell and those beside it, the nearest first.
std::vector<WalkNodeId> nodes_about(const WalkSpace& reached, const Vec3& at, bool has_height) {
    std::vector<std::pair<double, WalkNodeId>> near;
    const auto add = [&](const WalkNodeId& node) {
        Vec3 apart = reached.position(node) - at;
        apart.y() = has_height ? apart.y() : 0.0;
        near.emplace_back(apart.squaredNorm(), node);
    };
    const GridCell cell = reached.grid.cell_at(at);
    if (has_height) {
        for (int k = 0; k < 9; ++k) {
            if (const auto node =
                    reached.find({cell.x + k % 3 - 1, cell.z + k / 3 - 1}, at.y(), kLevelOfPoint)) {
                add(*node);
            }
        }
    } else {
        const double side = reached.grid.cell;
        const Vec3 least(side * (cell.x - 0.5), -1e9, side * (cell.z - 0.5));
        const Vec3 most(side * (cell.x + 1.5), 1e9, side * (cell.z + 1.5));
        std::ranges::for_each(reached.nodes_in({least, most}), add);
    }
    std::ranges::sort(near);
    std::vector<WalkNodeId> nodes;
    nodes.reserve(near.size());
    for (const auto& [apart, node] : near) {
        nodes.push_back(node);
    }
    return nodes;
}

}  // namespace

PointReach reach_point(const WalkSpace& reached, Strider& strider, const Vec3& at, bool has_height) {
    PointReach result;
    for (const WalkNodeId& node : nodes_about(reached, at, has_height)) {
        const GroundState from = reached.state_at(node, strider);
        const Vec3 target(at.x(), has_height ? at.y() : from.foot.y(), at.z());
        const StrideEnd end = strider.walk_to(from, target, 0.05, 2.0);
        const Vec3 apart = end.at.foot - target;
        if (end.kind == StrideEnd::Kind::grounded && collision::horizontal_norm(apart) <= 0.05 &&
            (!has_height || std::abs(apart.y()) <= kLevelOfPoint)) {
            result.node = node;
            result.foot = end.at.foot;
            return result;
        }
        result.nearest = std::min(result.nearest, apart.norm());
    }
    return result;
}

}  // namespace campuswalk::engine
