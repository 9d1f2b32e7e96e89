#include "engine/walkspace/space/walk_space.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/walkspace/space/tight_growth.h"

namespace campuswalk::engine {

namespace {

GridCell first_cell_of(const GridCell& cell) {
    return first_of_square(cell, WalkTile::kCells);
}

/// Of the cells of the nodes that count, m².
template <typename Counts>
double area_of(const WalkSpace& space, const Counts& counts) {
    std::size_t count = 0;
    for (const WalkTile& tile : space.tiles) {
        count += static_cast<std::size_t>(std::ranges::count_if(tile.nodes, counts));
    }
    return static_cast<double>(count) * space.grid.cell * space.grid.cell;
}

}  // namespace

double length_of(const std::vector<ChainLink>& chain) {
    double length = 0.0;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        length += (chain[i].at.foot - chain[i - 1].at.foot).norm();
    }
    return length;
}

bool WalkSpace::is_cut_by(Bound bound) const {
    return std::ranges::find(bounds, bound) != bounds.end();
}

std::size_t WalkSpace::node_count() const {
    std::size_t count = 0;
    for (const WalkTile& tile : tiles) {
        count += tile.nodes.size();
    }
    return count;
}

double WalkSpace::area() const {
    return area_of(*this, [](const WalkNode& node) { return node.hangs == 0; });
}

double WalkSpace::low_area() const {
    return area_of(*this, [](const WalkNode& node) { return node.hangs == 0 && node.low == 1; });
}

collision::Vec3 WalkSpace::position(const WalkNodeId& ref) const {
    collision::Vec3 p = grid.center(cell_of(ref));
    p.y() = static_cast<double>(node(ref).y);
    return p;
}

std::vector<WalkNodeId> WalkSpace::nodes_in(const collision::Aabb& box) const {
    const GridCell low = grid.cell_at(box.min);
    const GridCell high = grid.cell_at(box.max);
    std::vector<WalkNodeId> nodes;
    for (std::uint32_t t = 0; t < tiles.size(); ++t) {
        const WalkTile& tile = tiles[t];
        if (tile.first_cell.x > high.x || tile.first_cell.x + WalkTile::kCells <= low.x ||
            tile.first_cell.z > high.z || tile.first_cell.z + WalkTile::kCells <= low.z) {
            continue;
        }
        for (std::size_t n = 0; n < tile.nodes.size(); ++n) {
            const GridCell cell = tile.cell_of(tile.nodes[n]);
            const double y = static_cast<double>(tile.nodes[n].y);
            if (cell.x >= low.x && cell.x <= high.x && cell.z >= low.z && cell.z <= high.z &&
                y >= box.min.y() && y <= box.max.y()) {
                nodes.push_back({t, static_cast<std::uint16_t>(n)});
            }
        }
    }
    return nodes;
}

std::vector<WalkNodeId> WalkSpace::nodes_touching(const collision::Aabb& box,
                                                  const collision::MoverSettings& body) const {
    constexpr double kOffMiddle = 0.71;  // a body is at most so many cells from its cell's middle
    constexpr double kAtBox = 0.05;      // metres
    collision::Aabb feet = box.grown(body.radius + kOffMiddle * grid.cell);
    feet.min.y() = box.min.y() - body.height - kAtBox;
    feet.max.y() = box.max.y() + kAtBox;
    return nodes_in(feet);
}

std::optional<std::uint32_t> WalkSpace::tile_at(const GridCell& cell) const {
    const auto found = tile_numbers_.find(first_cell_of(cell));
    return found == tile_numbers_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<WalkNodeId> WalkSpace::find(const GridCell& cell, double y, double tolerance) const {
    const auto tile = tile_at(cell);
    if (!tile) {
        return std::nullopt;
    }
    const auto node = tiles[*tile].find(tiles[*tile].index_of(cell), y, tolerance);
    return node ? std::optional(WalkNodeId{*tile, *node}) : std::nullopt;
}

std::uint32_t WalkSpace::add_tile_at(const GridCell& cell) {
    const GridCell first_cell = first_cell_of(cell);
    const auto number = static_cast<std::uint32_t>(tiles.size());
    const auto [at, added] = tile_numbers_.emplace(first_cell, number);
    if (!added) {
        return at->second;
    }
    push_tightly(tiles, WalkTile(first_cell, number));
    for (int i = 0; i < 9; ++i) {
        const GridCell beside{first_cell.x + (i % 3 - 1) * WalkTile::kCells,
                              first_cell.z + (i / 3 - 1) * WalkTile::kCells};
        const auto other = tile_numbers_.find(beside);
        if (other != tile_numbers_.end() && i != 4) {
            tiles[number].neighbours[static_cast<std::size_t>(i)] = other->second;
            tiles[other->second].neighbours[static_cast<std::size_t>(8 - i)] = number;
        }
    }
    return number;
}

std::optional<WalkNodeId> WalkSpace::parent(const WalkNodeId& ref) const {
    const WalkTile& tile = tiles[ref.tile];
    const WalkNode& n = tile.nodes[ref.node];
    if (n.parent_tile == WalkNode::kStart) {
        return std::nullopt;
    }
    if (n.parent_tile == WalkNode::kFarParent) {
        const auto far = std::ranges::lower_bound(tile.far_parents, ref.node, {}, &WalkTile::FarParent::node);
        return WalkNodeId{far->tile, n.parent};
    }
    return WalkNodeId{tile.neighbours[n.parent_tile], n.parent};
}

double WalkSpace::length_to(const WalkNodeId& ref) const {
    double length = 0.0;
    WalkNodeId at = ref;
    for (auto before = parent(at); before; before = parent(at)) {
        length += (position(at) - position(*before)).norm();
        at = *before;
    }
    return length;
}

std::vector<ChainLink> WalkSpace::chain(const WalkNodeId& ref, Strider& strider) const {
    std::vector<ChainLink> links;
    std::optional<WalkNodeId> at = ref;
    while (at) {
        links.push_back({node(*at).stride(), {}});
        const auto before = parent(*at);
        if (!before) {
            links.back().at = *tiles[at->tile].keyframe(at->node);
        }
        at = before;
    }
    std::ranges::reverse(links);
    for (std::size_t i = 1; i < links.size(); ++i) {
        links[i].at = strider.take(links[i - 1].at, links[i].stride, grid).at;
    }
    return links;
}

GroundState WalkSpace::state_at(const WalkNodeId& ref, Strider& strider) const {
    std::vector<Stride> path;
    WalkNodeId at = ref;
    const GroundState* known = tiles[at.tile].keyframe(at.node);
    while (known == nullptr) {
        path.push_back(node(at).stride());
        at = *parent(at);
        known = tiles[at.tile].keyframe(at.node);
    }
    GroundState state = *known;
    for (auto stride = path.rbegin(); stride != path.rend(); ++stride) {
        state = strider.take(state, *stride, grid).at;
    }
    return state;
}

}  // namespace campuswalk::engine
