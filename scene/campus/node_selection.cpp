#include "scene/campus/node_selection.h"

#include <algorithm>
#include <set>

#include "scene/base/glob.h"

namespace campuswalk::scene {
namespace {

bool matches_any(std::span<const NodeGlob> globs, const std::string& name) {
    return std::ranges::any_of(globs, [&](const NodeGlob& glob) { return glob_matches(glob.pattern, name); });
}

/// The end of the message for a glob that matches nothing: a similar name, or some that exist.
std::string suggestion(const std::vector<Model>& models, const std::string& pattern) {
    constexpr std::size_t kNamesShown = 5;
    std::set<std::string> distinct;
    for (const Model& model : models) {
        for (const Node& node : model.nodes) {
            if (!node.name.empty()) {
                distinct.insert(node.name);
            }
        }
    }
    const std::vector<std::string> names(distinct.begin(), distinct.end());
    std::string plain = pattern;
    std::erase_if(plain, [](char c) { return c == '*' || c == '?'; });
    for (const std::string& word : {pattern, plain}) {
        const std::string_view near = nearest_word(word, names);
        if (!near.empty()) {
            return "; did you mean '" + std::string(near) + "'?";
        }
    }
    // A pattern such as `libary_*` isn't similar to any whole name, but to the start of one.
    for (const std::string& name : names) {
        if (name.size() > plain.size() && !nearest_word(plain, {name.substr(0, plain.size())}).empty()) {
            return "; did you mean '" + name + "'?";
        }
    }
    if (names.empty()) {
        return "; no node in the scenes has a name";
    }
    std::string shown;
    for (std::size_t i = 0; i < names.size() && i < kNamesShown; ++i) {
        shown += (i == 0 ? "'" : ", '") + names[i] + "'";
    }
    return "; the scenes contain " + shown + (names.size() > kNamesShown ? ", …" : "");
}

bool contains(std::span<const NodeRef> refs, const NodeRef& ref) {
    return std::binary_search(refs.begin(), refs.end(), ref);
}

void append_mesh(const Mesh& mesh, const Eigen::Matrix4d& X_world_mesh, WorldGeometry& out) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    const Eigen::Matrix3d linear = X_world_mesh.topLeftCorner<3, 3>();
    const Eigen::Vector3d offset = X_world_mesh.topRightCorner<3, 1>();
    for (const Eigen::Vector3f& position : mesh.positions) {
        out.positions.emplace_back(linear * position.cast<double>() + offset);
    }
    for (const auto& t : mesh.triangles) {
        out.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
}

}  // namespace

std::vector<NodeRef> topmost_matches(const std::vector<Model>& models, std::span<const NodeGlob> globs) {
    std::vector<NodeRef> matches;
    for (std::size_t m = 0; m < models.size(); ++m) {
        const std::vector<Node>& nodes = models[m].nodes;
        std::vector<bool> inside(nodes.size(), false);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const bool below = nodes[n].parent >= 0 && inside[static_cast<std::size_t>(nodes[n].parent)];
            inside[n] = below || matches_any(globs, nodes[n].name);
            if (inside[n] && !below) {
                matches.push_back({m, n});
            }
        }
    }
    return matches;
}

void check_globs(const std::vector<Model>& models, std::span<const NodeGlob> globs,
                 DiagnosticList& diagnostics) {
    for (const NodeGlob& glob : globs) {
        const bool matched = std::ranges::any_of(models, [&](const Model& model) {
            return std::ranges::any_of(
                model.nodes, [&](const Node& node) { return glob_matches(glob.pattern, node.name); });
        });
        if (!matched) {
            diagnostics.error(glob.mark, "no-node",
                              "no node is named '" + glob.pattern + "'" + suggestion(models, glob.pattern));
        }
    }
}

NodeSelection select_nodes(const std::vector<Model>& models, std::span<const NodeGlob> globs,
                           std::span<const NodeGlob> except) {
    NodeSelection selection{topmost_matches(models, globs), topmost_matches(models, except)};
    std::erase_if(selection.roots, [&](const NodeRef& root) {
        const std::vector<Node>& nodes = models[root.model].nodes;
        for (auto n = static_cast<int>(root.node); n >= 0; n = nodes[static_cast<std::size_t>(n)].parent) {
            if (contains(selection.except, {root.model, static_cast<std::size_t>(n)})) {
                return true;
            }
        }
        return false;
    });
    return selection;
}

std::vector<NodeRef> nodes_of(const std::vector<Model>& models, const NodeSelection& selection) {
    std::vector<NodeRef> found;
    for (const NodeRef& root : selection.roots) {
        const std::vector<Node>& nodes = models[root.model].nodes;
        std::vector<bool> inside(nodes.size(), false);
        for (std::size_t n = root.node; n < nodes.size(); ++n) {
            const bool below = nodes[n].parent >= 0 && inside[static_cast<std::size_t>(nodes[n].parent)];
            inside[n] = (n == root.node || below) && !contains(selection.except, {root.model, n});
            if (inside[n]) {
                found.push_back({root.model, n});
            }
        }
    }
    return found;
}

WorldGeometry gather_geometry(const std::vector<Model>& models, const NodeSelection& selection) {
    WorldGeometry geometry;
    for (const NodeRef& ref : nodes_of(models, selection)) {
        const Model& model = models[ref.model];
        const Node& node = model.nodes[ref.node];
        for (const MeshIndex mesh : node.meshes) {
            append_mesh(model.meshes[index_of(mesh)], node.X_world_node, geometry);
        }
    }
    return geometry;
}

}  // namespace campuswalk::scene
