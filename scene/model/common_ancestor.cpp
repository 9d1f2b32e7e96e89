#include "scene/model/common_ancestor.h"

#include <iterator>
#include <set>

namespace campuswalk::scene {

std::optional<std::size_t> common_ancestor(const Model& model, const std::vector<std::size_t>& nodes) {
    std::set<std::size_t> open(nodes.begin(), nodes.end());
    while (open.size() > 1) {
        const auto last =
            std::prev(open.end());  // none of the others is below it: parents precede their children
        const int parent = model.nodes[*last].parent;
        if (parent < 0) {
            return std::nullopt;
        }
        open.erase(last);
        open.insert(static_cast<std::size_t>(parent));
    }
    return *open.begin();
}

}  // namespace campuswalk::scene
