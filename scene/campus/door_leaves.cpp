#include "scene/campus/door_leaves.h"

#include <cstddef>
#include <map>

#include "scene/model/name_words.h"
#include "scene/model/named_parts.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {

std::vector<DoorLeaf> find_door_leaves(const Campus& campus) {
    std::map<NodeRef, UprightBoxFit> fits;
    std::vector<std::vector<std::size_t>> parts;
    const auto add = [&](const NodeRef& ref, const std::vector<MeshIndex>& meshes) {
        const std::size_t part = parts[ref.model][ref.node];
        if (part == kNoPart) {
            return;
        }
        const Model& model = campus.models[ref.model];
        Node leaf = model.nodes[ref.node];
        leaf.meshes = meshes;
        for_each_vertex(model, leaf, [&](const auto& p) { fits[{ref.model, part}].add(p); });
    };
    for (std::size_t m = 0; m < campus.models.size(); ++m) {
        const Model& model = campus.models[m];
        parts.push_back(named_parts(model, is_door_name));
        for (std::size_t n = 0; n < model.nodes.size(); ++n) {
            add({m, n}, model.nodes[n].meshes);
        }
    }
    for (const RemovedNode& removed : campus.open_doors) {
        add(removed.node, removed.meshes);
    }
    std::vector<DoorLeaf> leaves;
    leaves.reserve(fits.size());
    for (auto& [node, fit] : fits) {
        leaves.push_back({node, fit.box()});
    }
    return leaves;
}

}  // namespace campuswalk::scene
