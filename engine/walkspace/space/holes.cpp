#include "engine/walkspace/space/holes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "collision/geometry/disjoint_sets.h"

namespace campuswalk::engine {

namespace {

/// Edges nearer than this along the ground, in cells, and in height, in metres, are one hole's.
constexpr int kSameHole = 3;
constexpr double kSameHeight = 0.5;

}  // namespace

std::vector<Hole> find_holes(const WalkSpace& space) {
    std::vector<Hole::Edge> edges;
    for (std::uint32_t t = 0; t < space.tiles.size(); ++t) {
        for (const WalkTile::Drop& drop : space.tiles[t].drops) {
            edges.push_back({{t, drop.node}, drop.stride, drop.edge});
        }
    }
    std::map<GridCell, std::vector<std::size_t>> by_cell;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        by_cell[space.grid.cell_at(edges[i].at)].push_back(i);
    }
    collision::DisjointSets sets(edges.size());
    const auto is_jump = [&](std::size_t i) { return edges[i].stride.gait == Gait::jump; };
    std::vector<bool> is_before_edge(edges.size(), false);  // a jump from before an edge that one walks over
    for (const auto& [cell, here] : by_cell) {
        for (int dx = 0; dx <= kSameHole; ++dx) {
            for (int dz = dx == 0 ? 0 : -kSameHole; dz <= kSameHole; ++dz) {
                const auto near = by_cell.find({cell.x + dx, cell.z + dz});
                if (near == by_cell.end()) {
                    continue;
                }
                for (const std::size_t a : here) {
                    for (const std::size_t b : near->second) {
                        if (std::abs(edges[a].at.y() - edges[b].at.y()) <= kSameHeight) {
                            sets.join(a, b);
                            is_before_edge[a] = is_before_edge[a] || (is_jump(a) && !is_jump(b));
                            is_before_edge[b] = is_before_edge[b] || (is_jump(b) && !is_jump(a));
                        }
                    }
                }
            }
        }
    }
    std::map<std::size_t, Hole> holes;
    std::map<std::size_t, std::set<GridCell>> cells;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t root = sets.root(i);
        if (!is_before_edge[i] && cells[root].insert(space.grid.cell_at(edges[i].at)).second) {
            holes[root].edges.push_back(edges[i]);
            holes[root].length += space.grid.cell;
        }
    }
    std::vector<Hole> result;
    result.reserve(holes.size());
    for (auto& [root, hole] : holes) {
        result.push_back(std::move(hole));
    }
    std::ranges::stable_sort(result, std::greater(), &Hole::length);
    return result;
}

}  // namespace campuswalk::engine
