#include "scene/lint/level_patches.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "collision/geometry/disjoint_sets.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kLevel = 0.998;  // the least cosine to +Y: 3.6 degrees

/// Numbers the different positions of a node's vertices.
class PositionNumbers {
public:
    explicit PositionNumbers(double weld) : per_metre_(1.0 / weld) {}

    std::size_t of(const Vector3d& p) {
        const std::array<std::int64_t, 3> key = {std::llround(p.x() * per_metre_),
                                                 std::llround(p.y() * per_metre_),
                                                 std::llround(p.z() * per_metre_)};
        return numbers_.try_emplace(key, numbers_.size()).first->second;
    }
    std::size_t count() const { return numbers_.size(); }

private:
    struct Hash {
        std::size_t operator()(const std::array<std::int64_t, 3>& key) const {
            std::uint64_t hash = 0;
            for (const std::int64_t k : key) {
                hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15U;
                hash ^= hash >> 32U;
            }
            return hash;
        }
    };
    double per_metre_;
    std::unordered_map<std::array<std::int64_t, 3>, std::size_t, Hash> numbers_;
};

void add_patches(const Model& model, std::size_t node, double weld, std::vector<LevelPatch>& patches) {
    std::vector<std::array<Vector3d, 3>> level;
    std::vector<std::array<std::size_t, 3>> vertices;
    PositionNumbers numbers(weld);
    for_each_triangle(model, model.nodes[node], [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        const Vector3d normal = (b - a).cross(c - a);
        if (normal.y() > kLevel * normal.norm()) {
            level.push_back({a, b, c});
            vertices.push_back({numbers.of(a), numbers.of(b), numbers.of(c)});
        }
    });
    collision::DisjointSets sets(numbers.count());
    for (const auto& [a, b, c] : vertices) {
        sets.join(a, b);
        sets.join(b, c);
    }
    std::map<std::uint32_t, std::pair<UprightBoxFit, double>> fits;
    for (std::size_t t = 0; t < level.size(); ++t) {
        auto& [fit, area] = fits[sets.root(vertices[t][0])];
        const auto& [a, b, c] = level[t];
        area += 0.5 * std::abs((b - a).cross(c - a).y());
        for (const Vector3d& p : level[t]) {
            fit.add(p);
        }
    }
    for (auto& [root, patch] : fits) {
        patches.push_back({node, patch.first.box(), patch.second});
    }
}

}  // namespace

std::vector<LevelPatch> level_patches(const Model& model, double weld) {
    std::vector<LevelPatch> patches;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        add_patches(model, n, weld, patches);
    }
    return patches;
}

}  // namespace campuswalk::scene
