#include "scene/campus/open_doors.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "scene/campus/node_selection.h"
#include "scene/model/name_words.h"

namespace campuswalk::scene {
namespace {

std::set<NodeRef> excepted_doors(const Campus& campus) {
    std::set<NodeRef> doors;
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const collision::Object& object =
            campus.world.object(collision::ObjectId{static_cast<std::uint32_t>(i)});
        if (collision::any_of(object.detection, collision::Detection::solid)) {
            std::ranges::copy_if(campus.objects[i].nodes.except, std::inserter(doors, doors.end()),
                                 [&](const NodeRef& ref) {
                                     return is_door_name(campus.models[ref.model].nodes[ref.node].name);
                                 });
        }
    }
    return doors;
}

std::set<NodeRef> nodes_of_colliders(const Campus& campus) {
    std::set<NodeRef> nodes;
    for (const CampusObject& object : campus.objects) {
        for (const NodeRef& node : nodes_of(campus.models, object.nodes)) {
            nodes.insert(node);
        }
    }
    return nodes;
}

}  // namespace

void remove_open_doors(Campus& campus) {
    const std::set<NodeRef> doors = excepted_doors(campus);
    if (doors.empty()) {
        return;
    }
    const std::set<NodeRef> taken = nodes_of_colliders(campus);
    for (const NodeRef& door : doors) {
        const std::vector<NodeRef> subtree = nodes_of(campus.models, {{door}, {}});
        if (std::ranges::none_of(subtree, [&](const NodeRef& node) { return taken.contains(node); })) {
            for (const NodeRef& node : subtree) {
                campus.open_doors.push_back(
                    {node, std::exchange(campus.models[node.model].nodes[node.node].meshes, {})});
            }
        }
    }
}

}  // namespace campuswalk::scene
