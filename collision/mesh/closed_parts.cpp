#include "collision/mesh/closed_parts.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "collision/geometry/disjoint_sets.h"

namespace campuswalk::collision {

namespace {

constexpr std::size_t kWordBits = 64;

/// Mixes a position's bits; -0 hashes like 0.
std::uint64_t hash_of(const Eigen::Vector3f& p) {
    std::uint64_t hash = 0;
    for (Eigen::Index k = 0; k < 3; ++k) {
        hash = (hash ^ std::bit_cast<std::uint32_t>(p[k] + 0.0F)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

/// For each vertex, the index of the first one at its position.
std::vector<std::uint32_t> welded(const TriangleMesh& mesh) {
    constexpr std::uint32_t kFree = ~0U;
    const std::size_t mask = std::bit_ceil(2 * mesh.positions.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, kFree);
    std::vector<std::uint32_t> vertex(mesh.positions.size());
    for (std::uint32_t i = 0; i < vertex.size(); ++i) {
        const Eigen::Vector3f& p = mesh.positions[i];
        std::size_t at = hash_of(p) & mask;
        while (table[at] != kFree && mesh.positions[table[at]] != p) {
            at = (at + 1) & mask;
        }
        if (table[at] == kFree) {
            table[at] = i;
        }
        vertex[i] = table[at];
    }
    return vertex;
}

/// The triangles with their vertices welded.
class WeldedMesh {
public:
    explicit WeldedMesh(const TriangleMesh& mesh)
        : mesh_(mesh), vertex_(welded(mesh)), sets_(mesh.positions.size()) {
        for (const auto& t : mesh_.triangles) {
            sets_.join(vertex_[t[0]], vertex_[t[1]]);
            sets_.join(vertex_[t[1]], vertex_[t[2]]);
        }
    }

    /// The number of the part that a triangle belongs to.
    std::uint32_t part_of(std::size_t triangle) { return sets_.root(vertex_[mesh_.triangles[triangle][0]]); }

    /// By part: whether its triangles run along some edge more often in one direction than in the other.
    std::vector<bool> open_parts() {
        std::vector<bool> open(vertex_.size());
        const std::vector<std::uint32_t> first = group_edges();
        for (std::uint32_t v = 0; v < vertex_.size(); ++v) {
            if (is_unbalanced(std::span(ends_).subspan(first[v], first[v + 1] - first[v]))) {
                open[sets_.root(v)] = true;
            }
        }
        return open;
    }

private:
    /// Calls `visit(lower vertex, other vertex, whether it starts at the lower one)` for each side of each
    /// triangle that has a length.
    template <typename Visit>
    void for_each_edge(const Visit& visit) const {
        for (const auto& t : mesh_.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = vertex_[t[i]];
                const std::uint32_t b = vertex_[t[(i + 1) % 3]];
                if (a != b) {
                    visit(std::min(a, b), std::max(a, b), a < b);
                }
            }
        }
    }

    /// Groups the edges in `ends_` by their lower vertex; returns where each group begins.
    std::vector<std::uint32_t> group_edges() {
        std::vector<std::uint32_t> first(vertex_.size() + 1);
        for_each_edge([&](std::uint32_t low, std::uint32_t, bool) { ++first[low + 1]; });
        std::partial_sum(first.begin(), first.end(), first.begin());
        ends_.resize(first.back());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for_each_edge([&](std::uint32_t low, std::uint32_t high, bool up) {
            ends_[next[low]++] = std::uint64_t{high} << 1U | (up ? 1U : 0U);
        });
        return first;
    }

    static bool is_unbalanced(std::span<std::uint64_t> ends) {
        std::sort(ends.begin(), ends.end());
        std::int64_t balance = 0;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (i > 0 && ends[i] >> 1U != ends[i - 1] >> 1U && balance != 0) {
                return true;
            }
            balance += (ends[i] & 1U) != 0 ? 1 : -1;
        }
        return balance != 0;
    }

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> vertex_;
    DisjointSets sets_;
    std::vector<std::uint64_t>
        ends_;  ///< by lower vertex: twice the other one, plus 1 if the edge starts at the lower
};

bool is_finite(const Aabb& box) {
    return box.min.allFinite() && box.max.allFinite();
}

}  // namespace

ClosedParts::ClosedParts(const TriangleMesh& mesh) {
    WeldedMesh welded(mesh);
    std::vector<double> volume(mesh.positions.size());  // by part, six times, signed
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = vertices(mesh, i);
        volume[welded.part_of(i)] += t.a.dot(t.b.cross(t.c));
    }
    const std::vector<bool> open = welded.open_parts();
    std::vector<std::uint64_t> members((mesh.triangles.size() + kWordBits - 1) / kWordBits);
    bool some = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t part = welded.part_of(i);
        if (!open[part] && volume[part] > 0.0) {
            some = true;
            members[i / kWordBits] |= std::uint64_t{1} << i % kWordBits;
            const Triangle t = vertices(mesh, i);
            bounds_.extend(t.a);
            bounds_.extend(t.b);
            bounds_.extend(t.c);
        }
    }
    if (some) {
        members_ = std::move(members);
    }
}

ClosedParts::ClosedParts(Storage<std::uint64_t> members, const Aabb& bounds, std::size_t mesh_triangles)
    : members_(std::move(members)), bounds_(bounds) {
    if (!members_.empty() &&
        (members_.size() != (mesh_triangles + kWordBits - 1) / kWordBits || !is_finite(bounds))) {
        throw std::invalid_argument("the closed parts aren't those of the mesh");
    }
}

}  // namespace campuswalk::collision
