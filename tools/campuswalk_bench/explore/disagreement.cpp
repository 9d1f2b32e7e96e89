#include "tools/campuswalk_bench/explore/disagreement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tools/campuswalk_bench/explore/explored_campus.h"

namespace campuswalk::tools::bench {

using collision::Triangle;
using collision::Vec3;
using engine::GridCell;
using engine::WalkGrid;
using engine::WalkSpace;

namespace {

/// Metres; storeys are farther apart.
constexpr double kSameGround = 0.5;

/// By cell, the heights of ground in it.
using Heights = std::map<GridCell, std::vector<double>>;

bool has_near(const Heights& heights, const GridCell& cell, double y) {
    const auto found = heights.find(cell);
    return found != heights.end() &&
           std::ranges::any_of(found->second, [y](double at) { return std::abs(at - y) <= kSameGround; });
}

bool has_around(const Heights& heights, const GridCell& cell, double y) {
    for (int z = -1; z <= 1; ++z) {
        for (int x = -1; x <= 1; ++x) {
            if (has_near(heights, {cell.x + x, cell.z + z}, y)) {
                return true;
            }
        }
    }
    return false;
}

Heights heights_of(const WalkSpace& space) {
    Heights heights;
    for (const engine::WalkNodeId& node : nodes_of(space)) {
        heights[space.cell_of(node)].push_back(space.position(node).y());
    }
    return heights;
}

/// Twice the area from a to b to c, seen from above.
double area2(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x() - a.x()) * (c.z() - a.z()) - (c.x() - a.x()) * (b.z() - a.z());
}

/// Adds the triangle's height at the middle of each cell whose middle it covers.
void add(const Triangle& t, const WalkGrid& grid, Heights& heights) {
    const double whole = area2(t.a, t.b, t.c);
    if (whole == 0.0) {
        return;
    }
    const Vec3 low = t.a.cwiseMin(t.b).cwiseMin(t.c);
    const Vec3 high = t.a.cwiseMax(t.b).cwiseMax(t.c);
    const GridCell first = grid.cell_at(low);
    const GridCell last = grid.cell_at(high);
    for (int z = first.z; z <= last.z; ++z) {
        for (int x = first.x; x <= last.x; ++x) {
            const Vec3 p = grid.center({x, z});
            const double a = area2(p, t.b, t.c) / whole;
            const double b = area2(t.a, p, t.c) / whole;
            const double c = 1.0 - a - b;
            if (a >= 0.0 && b >= 0.0 && c >= 0.0) {
                std::vector<double>& of_cell = heights[{x, z}];
                const double y = a * t.a.y() + b * t.b.y() + c * t.c.y();
                if (std::ranges::none_of(of_cell, [y](double at) { return std::abs(at - y) < 0.01; })) {
                    of_cell.push_back(y);
                }
            }
        }
    }
}

/// A cell's middle and its neighbours' in turn, all that aren't in a cluster yet.
Cluster grow(Heights& left, GridCell cell, double y, const WalkGrid& grid) {
    std::vector<Vec3> members;
    std::vector<std::pair<GridCell, double>> open{{cell, y}};
    while (!open.empty()) {
        const auto [at, height] = open.back();
        open.pop_back();
        Vec3 middle = grid.center(at);
        middle.y() = height;
        members.push_back(middle);
        for (int z = -1; z <= 1; ++z) {
            for (int x = -1; x <= 1; ++x) {
                const GridCell other{at.x + x, at.z + z};
                const auto found = left.find(other);
                if (found == left.end()) {
                    continue;
                }
                const double from = height;
                const auto apart = [from](double h) { return std::abs(h - from) > kSameGround; };
                const auto near = std::partition(found->second.begin(), found->second.end(), apart);
                for (auto h = near; h != found->second.end(); ++h) {
                    open.emplace_back(other, *h);
                }
                found->second.erase(near, found->second.end());
            }
        }
    }
    Cluster cluster;
    cluster.cells = members.size();
    Vec3 sum = Vec3::Zero();
    for (const Vec3& member : members) {
        cluster.bounds.extend(member);
        sum += member;
    }
    const Vec3 mean = sum / static_cast<double>(members.size());
    cluster.at = *std::ranges::min_element(members, {}, [&](const Vec3& p) { return (p - mean).norm(); });
    return cluster;
}

/// What is in `one` without anything near in `other`.
OneSided only_in(const Heights& one, const Heights& other, const WalkGrid& grid) {
    Heights left;
    for (const auto& [cell, heights] : one) {
        for (const double y : heights) {
            if (!has_around(other, cell, y)) {
                left[cell].push_back(y);
            }
        }
    }
    OneSided found;
    for (auto& [cell, heights] : left) {
        while (!heights.empty()) {
            const double y = heights.back();
            heights.pop_back();
            found.clusters.push_back(grow(left, cell, y, grid));
            found.area += static_cast<double>(found.clusters.back().cells) * grid.cell * grid.cell;
        }
    }
    std::ranges::stable_sort(found.clusters, std::ranges::greater(), &Cluster::cells);
    return found;
}

}  // namespace

Disagreement compare(const WalkSpace& space, const std::vector<Triangle>& triangles) {
    Disagreement found;
    Heights peer;
    for (const Triangle& t : triangles) {
        found.polygon_area += 0.5 * std::abs(area2(t.a, t.b, t.c));
        add(t, space.grid, peer);
    }
    const Heights ours = heights_of(space);
    found.only_ours = only_in(ours, peer, space.grid);
    found.only_peer = only_in(peer, ours, space.grid);
    return found;
}

}  // namespace campuswalk::tools::bench
