#include "scene/suggest/solid_parts.h"

#include <algorithm>
#include <map>

#include "scene/base/glob.h"
#include "scene/model/name_words.h"

namespace campuswalk::scene {
namespace {

constexpr std::size_t kMostParts = 300;

/// Whether one of its triangles has an area: without one, nothing of it is solid.
bool has_area(const Mesh& mesh) {
    return std::ranges::any_of(mesh.triangles, [&](const auto& t) {
        const auto at = [&](std::size_t i) { return mesh.positions[t[i]].template cast<double>().eval(); };
        return !(at(1) - at(0)).cross(at(2) - at(0)).isZero(0.0);
    });
}

class PartSearch {
public:
    PartSearch(const Model& model, const std::vector<SuggestedBuilding>& buildings,
               const std::vector<std::string>& doors)
        : model_(model),
          children_(model.nodes.size()),
          has_triangles_(model.nodes.size(), false),
          in_building_(model.nodes.size(), false),
          holds_building_(model.nodes.size(), false) {
        for (const SuggestedBuilding& building : buildings) {
            for (const std::string& glob : building.globs) {
                for (const std::size_t node : match_nodes(model, glob)) {
                    in_building_[node] = true;
                }
            }
        }
        for (std::size_t n = model.nodes.size(); n-- > 0;) {
            const Node& node = model.nodes[n];
            ++uses_[node.name];
            for (const MeshIndex mesh : node.meshes) {
                has_triangles_[n] = has_triangles_[n] || has_area(model.meshes[index_of(mesh)]);
            }
            if (std::ranges::find(doors, node.name) != doors.end()) {
                has_triangles_[n] = false;  // that are solid
            }
            if (node.parent >= 0) {
                const auto parent = static_cast<std::size_t>(node.parent);
                children_[parent].push_back(n);
                has_triangles_[parent] = has_triangles_[parent] || has_triangles_[n];
                holds_building_[parent] = holds_building_[parent] || holds_building_[n] || in_building_[n];
            }
        }
    }

    SolidParts run() {
        SolidParts parts;
        for (std::size_t n = 0; n < model_.nodes.size(); ++n) {
            if (model_.nodes[n].parent < 0) {
                add(n, parts);
            }
        }
        parts.are_the_rest = parts.is_all && std::ranges::all_of(parts_, [&](std::size_t n) {
                                 return model_.nodes[n].parent < 0;
                             });
        for (const std::vector<std::size_t>& alike : by_beginning()) {
            const std::string glob = glob_for(beginning(model_.nodes[alike.front()].name)) + "*";
            if (alike.size() >= kMany && match_nodes(model_, glob) == subtrees(alike)) {
                parts.globs.push_back(glob);
            } else {
                for (const std::size_t node : alike) {
                    parts.globs.push_back(glob_for(model_.nodes[node].name));
                }
            }
        }
        return parts;
    }

private:
    static constexpr std::size_t kMany = 3;

    /// Without the number at its end: `wall_` of `wall_12`.
    static std::string beginning(const std::string& name) {
        const std::size_t end = name.find_last_not_of("0123456789");
        return end == std::string::npos ? name : name.substr(0, end + 1);
    }

    /// The parts, those that are numbered alike together, in the order of the first of each.
    std::vector<std::vector<std::size_t>> by_beginning() const {
        std::vector<std::vector<std::size_t>> groups;
        std::map<std::string, std::size_t> numbers;
        for (const std::size_t node : parts_) {
            const auto [known, is_new] = numbers.emplace(beginning(model_.nodes[node].name), groups.size());
            if (is_new) {
                groups.emplace_back();
            }
            groups[known->second].push_back(node);
        }
        return groups;
    }

    std::vector<std::size_t> subtrees(const std::vector<std::size_t>& roots) const {
        std::vector<std::size_t> nodes;
        std::vector<std::size_t> stack = roots;
        while (!stack.empty()) {
            const std::size_t n = stack.back();
            stack.pop_back();
            nodes.push_back(n);
            stack.insert(stack.end(), children_[n].begin(), children_[n].end());
        }
        std::ranges::sort(nodes);
        return nodes;
    }

    void add(std::size_t root, SolidParts& parts) {
        std::vector<std::size_t> stack = {root};
        while (!stack.empty()) {
            const std::size_t n = stack.back();
            stack.pop_back();
            if (in_building_[n] || !has_triangles_[n]) {
                continue;
            }
            const std::string& name = model_.nodes[n].name;
            const bool is_told = uses_.at(name) == 1 && !name.empty() && !is_generated_name(name);
            const bool is_group = !children_[n].empty() && model_.nodes[n].meshes.empty();
            const bool is_opened =
                is_group &&
                (holds_building_[n] || !is_told ||
                 (is_default_name(name) && parts_.size() + stack.size() + children_[n].size() <= kMostParts));
            if (is_opened) {
                stack.insert(stack.end(), children_[n].begin(), children_[n].end());
            } else if (is_told && !holds_building_[n] && parts_.size() < kMostParts) {
                parts_.push_back(n);
            } else {
                parts.is_all = false;
            }
        }
    }

    const Model& model_;
    std::vector<std::vector<std::size_t>> children_;  ///< the last first
    std::vector<bool> has_triangles_;                 ///< in the subtree
    std::vector<bool> in_building_;
    std::vector<bool> holds_building_;
    std::map<std::string, std::size_t> uses_;
    std::vector<std::size_t> parts_;
};

}  // namespace

SolidParts solid_parts(const Model& model, const std::vector<SuggestedBuilding>& buildings,
                       const std::vector<std::string>& doors) {
    return PartSearch(model, buildings, doors).run();
}

}  // namespace campuswalk::scene
