#include "scene/lint/named_parts.h"

namespace campuswalk::scene {

std::vector<std::size_t> named_parts(const Model& model, bool (*is_called)(std::string_view)) {
    const std::size_t count = model.nodes.size();
    std::vector<bool> called(count, false);
    std::vector<bool> gathers(count, false);  // has one that is called so below it
    for (std::size_t n = count; n-- > 0;) {   // children first: parents come before them
        const Node& node = model.nodes[n];
        called[n] = is_called(node.name);
        if (node.parent >= 0 && (called[n] || gathers[n])) {
            gathers[static_cast<std::size_t>(node.parent)] = true;
        }
    }
    std::vector<std::size_t> part(count, kNoPart);
    for (std::size_t n = 0; n < count; ++n) {
        const Node& node = model.nodes[n];
        if (node.parent >= 0) {
            part[n] = part[static_cast<std::size_t>(node.parent)];
        }
        if (part[n] == kNoPart && called[n] && (!gathers[n] || !node.meshes.empty())) {
            part[n] = n;
        }
    }
    return part;
}

}  // namespace campuswalk::scene
