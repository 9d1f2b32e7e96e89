#include "scene/lint/doors.h"

#include <algorithm>

#include "scene/lint/closed_doors.h"
#include "scene/model/name_words.h"
#include "scene/model/named_parts.h"
#include "scene/model/upright_box.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {

std::vector<Door> find_doors(const Model& model) {
    const std::vector<std::size_t> parts = named_parts(model, is_door_name);
    std::vector<UprightBoxFit> fits(model.nodes.size());
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (parts[n] != kNoPart) {
            for_each_vertex(model, model.nodes[n], [&](const Eigen::Vector3d& p) { fits[parts[n]].add(p); });
        }
    }
    std::vector<Door> doors;
    for (const ClosedDoor& closed : find_closed_doors(model)) {
        doors.push_back({closed.node, closed.foot, closed.width, closed.height, true});
        fits[closed.node] = {};
    }
    for (std::size_t n = 0; n < fits.size(); ++n) {
        if (!fits[n].empty()) {
            const UprightBox box = fits[n].box();
            const Eigen::Vector3d foot = box.center - 0.5 * box.size.y() * Eigen::Vector3d::UnitY();
            doors.push_back({n, foot, std::max(box.size.x(), box.size.z()), box.size.y(), false});
        }
    }
    std::ranges::stable_sort(doors, {}, &Door::node);
    return doors;
}

}  // namespace campuswalk::scene
