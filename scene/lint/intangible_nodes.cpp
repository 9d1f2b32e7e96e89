#include "scene/lint/intangible_nodes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

/// Returns for each node the node that it is named by: itself or, if its name only says how it was modelled,
/// the nearest one above it whose name says more.
std::vector<std::size_t> named_by(const Model& model) {
    std::vector<std::size_t> named(model.nodes.size());
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {  // parents first
        const std::string& name = model.nodes[n].name;
        const int parent = model.nodes[n].parent;
        const bool tells = !(name.empty() || is_default_name(name) || is_generated_name(name));
        named[n] = tells || parent < 0 ? n : named[static_cast<std::size_t>(parent)];
    }
    return named;
}

std::vector<Bounds> bounds_of_nodes(const Model& model) {
    std::vector<Bounds> bounds(model.nodes.size());
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        for_each_vertex(model, model.nodes[n], [&](const Vector3d& p) { bounds[n].extend(p); });
    }
    return bounds;
}

/// Returns for each node the bounds of all other nodes that aren't left out.
std::vector<Bounds> bounds_of_others(const std::vector<Bounds>& bounds,
                                     const std::vector<bool>& is_left_out) {
    std::vector<Bounds> others(bounds.size());
    Bounds before;
    for (std::size_t n = 0; n < bounds.size(); ++n) {
        others[n] = before;
        before.extend(is_left_out[n] ? Bounds() : bounds[n]);
    }
    Bounds after;
    for (std::size_t n = bounds.size(); n-- > 0;) {
        others[n].extend(after);
        after.extend(is_left_out[n] ? Bounds() : bounds[n]);
    }
    return others;
}

/// Whether the plan of one lies within the other's.
bool surrounds(const Bounds& outer, const Bounds& inner) {
    return !inner.empty() && outer.min.x() < inner.min.x() && outer.max.x() > inner.max.x() &&
           outer.min.z() < inner.min.z() && outer.max.z() > inner.max.z();
}

/// Whether all vertices are about as far from a centre on the axis of the box as half its width.
bool is_round(const Model& model, std::size_t node, const Bounds& bounds) {
    constexpr double kUneven = 0.06;  // of the radius
    constexpr std::size_t kFewest = 16;
    const Vector3d size = bounds.max - bounds.min;
    const double radius = 0.5 * std::max(size.x(), size.z());
    Vector3d center = bounds.center();
    center.y() = bounds.max.y() - radius;
    bool is_even = std::min(size.x(), size.z()) > 2.0 * (1.0 - kUneven) * radius;
    std::size_t vertices = 0;
    for_each_vertex(model, model.nodes[node], [&](const Vector3d& p) {
        is_even = is_even && std::abs((p - center).norm() - radius) < kUneven * radius;
        ++vertices;
    });
    return is_even && vertices >= kFewest;
}

/// Returns for each node whether it is a sky. Domes, balls and boxes around everything that isn't called a
/// sky are, and so are clouds high above that.
std::vector<bool> find_skies(const Model& model, const std::vector<Bounds>& bounds,
                             const std::vector<std::size_t>& named) {
    std::vector<bool> is_named(bounds.size(), false);
    Bounds all;
    Bounds below;
    for (std::size_t n = 0; n < bounds.size(); ++n) {
        is_named[n] = !bounds[n].empty() && is_sky_name(model.nodes[named[n]].name);
        all.extend(bounds[n]);
        below.extend(is_named[n] ? Bounds() : bounds[n]);
    }
    const std::vector<Bounds> others = bounds_of_others(bounds, is_named);
    const auto covers = [&](std::size_t n, const Bounds& rest) {
        return surrounds(bounds[n], rest) && bounds[n].max.y() > rest.max.y();
    };
    const auto is_high = [&](const Bounds& clouds) {
        return !below.empty() && clouds.min.y() > below.max.y() + 0.5 * (below.max.y() - below.min.y());
    };
    std::vector<bool> is_sky(bounds.size(), false);
    for (std::size_t n = 0; n < bounds.size(); ++n) {
        if (is_named[n]) {
            is_sky[n] = covers(n, below) || is_high(bounds[n]);
        } else if (bounds[n].max.x() - bounds[n].min.x() >= 0.9 * (all.max.x() - all.min.x())) {
            is_sky[n] = covers(n, others[n]) && is_round(model, n, bounds[n]);
        }
    }
    return is_sky;
}

/// Whether everything lies nearly in one level plane.
bool is_level(const Bounds& bounds) {
    constexpr double kFlat = 0.02;  // of its width
    const Vector3d size = bounds.max - bounds.min;
    return size.y() <= kFlat * std::max(size.x(), size.z());
}

/// Whether it is a box of twelve triangles.
bool is_box(const Model& model, std::size_t node) {
    std::size_t triangles = 0;
    for (const MeshIndex mesh : model.nodes[node].meshes) {
        triangles += model.meshes[index_of(mesh)].triangles.size();
    }
    return triangles == 12;
}

std::optional<IntangibleNode::Kind> kind_of(const Model& model, std::size_t node, const Bounds& bounds,
                                            const std::string& name) {
    if (is_water_name(name) && is_level(bounds)) {
        return IntangibleNode::Kind::water;
    }
    if (is_operand_name(name) && is_box(model, node)) {
        return IntangibleNode::Kind::operand;
    }
    return std::nullopt;
}

}  // namespace

std::vector<IntangibleNode> intangible_nodes(const Model& model) {
    const std::vector<Bounds> bounds = bounds_of_nodes(model);
    const std::vector<std::size_t> named = named_by(model);
    const std::vector<bool> is_sky = find_skies(model, bounds, named);
    std::map<std::string, std::size_t> uses;
    std::vector<bool> has_children(model.nodes.size(), false);
    for (const Node& node : model.nodes) {
        ++uses[node.name];
        if (node.parent >= 0) {
            has_children[static_cast<std::size_t>(node.parent)] = true;
        }
    }
    std::vector<IntangibleNode> found;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const std::string& name = model.nodes[n].name;
        if (bounds[n].empty() || name.empty() || uses.at(name) > 1 || has_children[n]) {
            continue;
        }
        if (const auto kind = is_sky[n] ? std::optional(IntangibleNode::Kind::sky)
                                        : kind_of(model, n, bounds[n], model.nodes[named[n]].name)) {
            found.push_back({n, *kind});
        }
    }
    return found;
}

}  // namespace campuswalk::scene
