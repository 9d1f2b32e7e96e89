#include "engine/walkspace/space/walk_tile.h"

#include <algorithm>
#include <cassert>

#include "engine/walkspace/space/tight_growth.h"

namespace campuswalk::engine {

WalkTile::WalkTile(const GridCell& lowest, std::uint32_t own_index)
    : first_cell(lowest), newest(std::size_t{kCells} * kCells, WalkNode::kNone) {
    neighbours.fill(kNoTile);
    neighbours[4] = own_index;
}

std::optional<std::uint16_t> WalkTile::find(std::uint32_t cell, double y, double tolerance) const {
    std::optional<std::uint16_t> nearest;
    for (std::uint16_t i = newest[cell]; i != WalkNode::kNone; i = nodes[i].next) {
        if (const double apart = std::abs(static_cast<double>(nodes[i].y) - y); apart <= tolerance) {
            tolerance = apart;
            nearest = i;
        }
    }
    return nearest;
}

bool WalkTile::has(std::uint32_t cell, double y, bool hangs) const {
    for (std::uint16_t i = newest[cell]; i != WalkNode::kNone; i = nodes[i].next) {
        if (WalkNode::is_one_level(static_cast<double>(nodes[i].y) - y, hangs || nodes[i].hangs != 0)) {
            return true;
        }
    }
    return false;
}

std::uint16_t WalkTile::add(WalkNode node) {
    assert(nodes.size() < kMaxNodes);
    const auto index = static_cast<std::uint16_t>(nodes.size());
    node.next = newest[node.cell];
    newest[node.cell] = index;
    push_tightly(nodes, node);
    return index;
}

bool WalkTile::has_drop_from(const collision::Vec3& edge, const WalkGrid& grid) const {
    constexpr double kSameEdge = 0.01;  // metres
    const GridCell cell = grid.cell_at(edge);
    return std::ranges::any_of(drops, [&](const Drop& drop) {
        return std::abs(drop.edge.y() - edge.y()) <= kSameEdge && grid.cell_at(drop.edge) == cell;
    });
}

const GroundState* WalkTile::keyframe(std::uint16_t node) const {
    const auto found = std::ranges::lower_bound(keyframes, node, {}, &Keyframe::node);
    return found != keyframes.end() && found->node == node ? &found->at : nullptr;
}

}  // namespace campuswalk::engine
