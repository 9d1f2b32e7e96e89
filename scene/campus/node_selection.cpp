#include "scene/campus/node_selection.h"

#include <algorithm>
#include <set>

#include "scene/base/glob.h"

namespace campuswalk::scene {
namespace {

/// The topmost nodes that `matches` is true for.
template <typename Matches>
std::vector<NodeRef> topmost(const std::vector<Model>& models, const Matches& matches) {
    std::vector<NodeRef> found;
    for (std::size_t m = 0; m < models.size(); ++m) {
        const std::vector<Node>& nodes = models[m].nodes;
        std::vector<bool> inside(nodes.size(), false);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const bool below = nodes[n].parent >= 0 && inside[static_cast<std::size_t>(nodes[n].parent)];
            inside[n] = below || matches(nodes[n]);
            if (inside[n] && !below) {
                found.push_back({m, n});
            }
        }
    }
    return found;
}

std::vector<std::string> distinct_names(const std::vector<Model>& models) {
    std::set<std::string> names;
    for (const Model& model : models) {
        for (const Node& node : model.nodes) {
            if (!node.name.empty()) {
                names.insert(node.name);
            }
        }
    }
    return {names.begin(), names.end()};
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
    return topmost(models, [&](const Node& node) {
        return std::ranges::any_of(
            globs, [&](const NodeGlob& glob) { return glob_matches(glob.pattern, node.name); });
    });
}

bool NodeSelector::matches(const NodeGlob& glob, const Node& node) {
    const bool matches = glob_matches(glob.pattern, node.name, compared_);
    if (compared_ > max_compared_) {
        throw InputError(glob.mark, "too-large",
                         "the globs up to this one take more than " + std::to_string(max_compared_) +
                             " comparisons with the names of nodes; use fewer or shorter ones");
    }
    return matches;
}

NodeSelection NodeSelector::select(std::span<const NodeGlob> globs, std::span<const NodeGlob> except) {
    const auto topmost_of = [&](std::span<const NodeGlob> any) {
        return topmost(models_, [&](const Node& node) {
            return std::ranges::any_of(any, [&](const NodeGlob& glob) { return matches(glob, node); });
        });
    };
    NodeSelection selection{topmost_of(globs), topmost_of(except)};
    std::erase_if(selection.roots, [&](const NodeRef& root) {
        const std::vector<Node>& nodes = models_[root.model].nodes;
        for (auto n = static_cast<int>(root.node); n >= 0; n = nodes[static_cast<std::size_t>(n)].parent) {
            if (contains(selection.except, {root.model, static_cast<std::size_t>(n)})) {
                return true;
            }
        }
        return false;
    });
    return selection;
}

void NodeSelector::check(std::span<const NodeGlob> globs, DiagnosticList& diagnostics) {
    constexpr int kMaxSuggestions = 100;  // each looks at every name
    for (const NodeGlob& glob : globs) {
        bool found = false;
        for (const Model& model : models_) {
            for (const Node& node : model.nodes) {
                found = matches(glob, node) || found;  // all are counted, as whoever draws compares all
            }
        }
        if (!found) {
            const bool suggests = ++suggestions_ <= kMaxSuggestions;
            diagnostics.error(glob.mark, "no-node",
                              "no node is named '" + glob.pattern + "'" +
                                  (suggests ? suggestion(glob.pattern) : std::string()));
        }
    }
}

/// The end of the message for a glob that matches nothing: a similar name, or some that exist.
std::string NodeSelector::suggestion(const std::string& pattern) {
    constexpr std::size_t kNamesShown = 5;
    if (names_.empty()) {
        names_ = distinct_names(models_);
    }
    std::string plain = pattern;
    std::erase_if(plain, [](char c) { return c == '*' || c == '?'; });
    for (const std::string& word : {pattern, plain}) {
        const std::string_view near = nearest_word(word, names_);
        if (!near.empty()) {
            return "; did you mean '" + glob_for(near) + "'?";
        }
    }
    // A pattern such as `libary_*` isn't similar to any whole name, but to the start of one.
    for (const std::string& name : names_) {
        if (name.size() > plain.size() && !nearest_word(plain, {name.substr(0, plain.size())}).empty()) {
            return "; did you mean '" + glob_for(name) + "'?";
        }
    }
    if (names_.empty()) {
        return "; no node in the scenes has a name";
    }
    std::string shown;
    for (std::size_t i = 0; i < names_.size() && i < kNamesShown; ++i) {
        shown += (i == 0 ? "'" : ", '") + glob_for(names_[i]) + "'";
    }
    return "; the scenes contain " + shown + (names_.size() > kNamesShown ? ", …" : "");
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
