#include "collision/closed_parts.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

/// Gives each corner the number of its position.
std::vector<std::uint32_t> welded(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) {
        const auto& p = mesh.positions[i];
        return std::tuple(p.x(), p.y(), p.z());
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> vertex(mesh.positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i - 1]) == key(order[i]);
        vertex[order[i]] = same ? vertex[order[i - 1]] : order[i];
    }
    return vertex;
}

/// Disjoint sets of vertices, by path halving.
class Sets {
public:
    explicit Sets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> parent_;
};

struct Part {
    bool closed = true;
    double volume = 0.0;  ///< six times, signed
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

}  // namespace

ClosedParts::ClosedParts(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> vertex = welded(mesh);
    Sets sets(mesh.positions.size());
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Edge edge{vertex[t[i]], vertex[t[(i + 1) % 3]]};
            edges.push_back(edge);
            sets.join(edge.first, edge.second);
        }
    }
    std::sort(edges.begin(), edges.end());

    std::map<std::uint32_t, Part> parts;
    const auto count = [&](const Edge& e) {
        const auto range = std::equal_range(edges.begin(), edges.end(), e);
        return range.second - range.first;
    };
    for (const Edge& e : edges) {
        if (count(e) != count({e.second, e.first})) {
            parts[sets.find(e.first)].closed = false;
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = corners(mesh, i);
        parts[sets.find(vertex[mesh.triangles[i][0]])].volume += t.a.dot(t.b.cross(t.c));
    }
    std::vector<bool> members(mesh.triangles.size());
    bool some = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Part& part = parts[sets.find(vertex[mesh.triangles[i][0]])];
        if (part.closed && part.volume > 0.0) {
            members[i] = some = true;
            const Triangle t = corners(mesh, i);
            bounds_.extend(t.a);
            bounds_.extend(t.b);
            bounds_.extend(t.c);
        }
    }
    if (some) {
        members_ = std::move(members);
    }
}

}  // namespace campuswalk::collision
