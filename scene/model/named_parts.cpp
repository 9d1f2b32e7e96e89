#include "scene/model/named_parts.h"

namespace campuswalk::scene {

std::vector<std::size_t> named_parts(const Model& model, bool (*name_matches)(std::string_view)) {
    const std::size_t count = model.nodes.size();
    std::vector<bool> matches(count, false);
    std::vector<bool> is_group(count, false);  // has a matching descendant
    for (std::size_t n = count; n-- > 0;) {    // children first
        const Node& node = model.nodes[n];
        matches[n] = name_matches(node.name);
        if (node.parent >= 0 && (matches[n] || is_group[n])) {
            is_group[static_cast<std::size_t>(node.parent)] = true;
        }
    }
    std::vector<std::size_t> part(count, kNoPart);
    for (std::size_t n = 0; n < count; ++n) {
        const Node& node = model.nodes[n];
        if (node.parent >= 0) {
            part[n] = part[static_cast<std::size_t>(node.parent)];
        }
        if (part[n] == kNoPart && matches[n] && (!is_group[n] || !node.meshes.empty())) {
            part[n] = n;
        }
    }
    return part;
}

}  // namespace campuswalk::scene
