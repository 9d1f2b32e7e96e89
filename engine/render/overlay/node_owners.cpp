#include "engine/render/overlay/node_owners.h"

#include <algorithm>
#include <tuple>

namespace campuswalk::engine::render {
namespace {

// The nodes that a building or an object claims.
struct Claim {
    std::size_t owner = 0;
    bool invisible = false;
    std::vector<std::uint32_t> nodes;  // node numbers
};

// The number of each model's first node, then the next free number.
std::vector<std::uint32_t> first_numbers(const std::vector<scene::Model>& models) {
    std::vector<std::uint32_t> first = {1};
    for (const scene::Model& model : models) {
        first.push_back(first.back() + static_cast<std::uint32_t>(model.nodes.size()));
    }
    return first;
}

std::vector<std::uint32_t> numbers_of(const scene::Campus& campus, const scene::NodeSelection& selection) {
    const std::vector<std::uint32_t> first = first_numbers(campus.models);
    std::vector<std::uint32_t> numbers;
    for (const scene::NodeRef& ref : scene::nodes_of(campus.models, selection)) {
        numbers.push_back(first[ref.model] + static_cast<std::uint32_t>(ref.node));
    }
    return numbers;
}

// The owner of each node, if any.
std::vector<std::optional<std::size_t>> assign_owners(std::vector<Claim> claims, std::size_t nodes) {
    std::vector<std::optional<std::size_t>> owners(nodes + 1);
    std::ranges::stable_sort(claims, [](const Claim& a, const Claim& b) {
        return std::tuple(a.invisible, a.nodes.size(), a.owner) <
               std::tuple(b.invisible, b.nodes.size(), b.owner);
    });
    for (const Claim& claim : claims) {
        for (const std::uint32_t node : claim.nodes) {
            if (!owners[node]) {
                owners[node] = claim.owner;
            }
        }
    }
    return owners;
}

bool only_trigger(const scene::Campus& campus, std::size_t object) {
    return campus.world.object(collision::ObjectId{static_cast<std::uint32_t>(object)}).detection ==
           collision::Detection::trigger;
}

}  // namespace

NodeOwners find_node_owners(const scene::Campus& campus) {
    const std::size_t nodes = first_numbers(campus.models).back() - 1;
    std::vector<Claim> of_buildings;
    for (std::size_t i = 0; i < campus.description.buildings.size(); ++i) {
        const auto roots = scene::topmost_matches(campus.models, campus.description.buildings[i].nodes);
        of_buildings.push_back({i, false, numbers_of(campus, {roots, {}})});
    }
    std::vector<Claim> of_objects;
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        of_objects.push_back({i, only_trigger(campus, i), numbers_of(campus, campus.objects[i].nodes)});
    }
    const auto buildings = assign_owners(std::move(of_buildings), nodes);
    const auto objects = assign_owners(std::move(of_objects), nodes);

    std::vector<PixelOwner> by_node(nodes + 1);
    for (std::size_t n = 1; n <= nodes; ++n) {
        by_node[n] = {buildings[n], objects[n]};
        if (!buildings[n] && objects[n]) {
            by_node[n].building = campus.objects[*objects[n]].building;
        }
    }
    NodeOwners result;
    result.owners = by_node;
    // nullopt is less than any index, so the unowned come first.
    const auto rank = [](const PixelOwner& owner) { return std::tie(owner.building, owner.object); };
    std::ranges::sort(result.owners, {}, rank);
    result.owners.erase(std::unique(result.owners.begin(), result.owners.end()), result.owners.end());
    for (const PixelOwner& owner : by_node) {
        const auto found = std::ranges::lower_bound(result.owners, rank(owner), {}, rank);
        result.owner_of_node.push_back(static_cast<std::uint32_t>(found - result.owners.begin()));
    }
    return result;
}

}  // namespace campuswalk::engine::render
