#include "scene/osm/bridges/bridge_network.h"

#include <algorithm>
#include <functional>
#include <queue>

#include "scene/osm/bridges/bridge_crossings.h"

namespace campuswalk::scene::osm {

BridgeNetwork::BridgeNetwork(const std::vector<MapArea>& areas, const std::vector<Path>& paths)
    : areas_(areas), paths_(paths) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (std::size_t k = 0; !paths[i].unbuilt && k < paths[i].way->nodes.size(); ++k) {
            at_[paths[i].way->nodes[k]].emplace_back(i, k);
        }
    }
    for (const MapArea& area : areas) {
        for (const MapWay* way : area.outlines) {
            if (is_building(area.tags)) {
                walls_.insert(way->nodes.begin(), way->nodes.end());
            }
        }
    }
}

const std::vector<std::pair<std::size_t, std::size_t>>& BridgeNetwork::at(std::int64_t node) const {
    static const std::vector<std::pair<std::size_t, std::size_t>> kNone;
    const auto found = at_.find(node);
    return found == at_.end() ? kNone : found->second;
}

double BridgeNetwork::width_at(std::int64_t node) const {
    double width = 0.0;
    for (const auto& [path, place] : at(node)) {
        width = std::max(width, paths_[path].width);
    }
    return width;
}

bool BridgeNetwork::may_be_above(const Path& path) {
    return !path.unbuilt && !path.steps && layer_of(path.way->tags) > 0.0;
}

std::vector<Bridge> BridgeNetwork::bridges() const {
    std::vector<Bridge> bridges;
    std::vector<bool> taken(paths_.size(), false);
    for (std::size_t first = 0; first < paths_.size(); ++first) {
        if (!taken[first] && may_be_above(paths_[first])) {
            bridges.push_back(connected_to(first, taken));
            find_ends(bridges.back());
        }
    }
    find_outlines(bridges);
    std::ranges::stable_sort(bridges, {}, [&](const Bridge& bridge) { return layer(bridge); });
    return bridges;
}

Bridge BridgeNetwork::connected_to(std::size_t first, std::vector<bool>& taken) const {
    Bridge bridge;
    std::vector<std::size_t> open = {first};
    taken[first] = true;
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        bridge.paths.push_back(i);
        for (const std::int64_t node : paths_[i].way->nodes) {
            for (const auto& [other, place] : at(node)) {
                if (!taken[other] && may_be_above(paths_[other])) {
                    taken[other] = true;
                    open.push_back(other);
                }
            }
        }
    }
    std::ranges::sort(bridge.paths);
    return bridge;
}

void BridgeNetwork::find_ends(Bridge& bridge) const {
    std::unordered_set<std::int64_t> seen;
    for (const std::size_t i : bridge.paths) {
        const MapWay& way = *paths_[i].way;
        bridge.thickness = std::max(bridge.thickness, paths_[i].carriageway ? 0.6 : 0.4);
        for (std::size_t k = 0; k < way.nodes.size(); ++k) {
            if (!seen.insert(way.nodes[k]).second) {
                continue;
            }
            bool leads_on = false;
            bool stairs = false;
            std::size_t here = 0;
            for (const auto& [other, place] : at(way.nodes[k])) {
                const bool above = may_be_above(paths_[other]);
                here += above ? 1 : 0;
                stairs = stairs || paths_[other].steps;
                leads_on = leads_on || (!above && !paths_[other].steps);
            }
            const bool last = here == 1 && (k == 0 || k + 1 == way.nodes.size());
            if (leads_on || (last && !stairs && !walls_.contains(way.nodes[k]))) {
                bridge.open_ends.push_back(way.nodes[k]);
            } else if (stairs) {
                bridge.stair_ends.push_back(way.nodes[k]);
            }
        }
    }
}

/// Each belongs to the bridge that runs farthest in it.
void BridgeNetwork::find_outlines(std::vector<Bridge>& bridges) const {
    constexpr double kLeast = 1.0;  // metres
    for (std::size_t i = 0; i < areas_.size(); ++i) {
        if (!areas_[i].tags.is("man_made", "bridge")) {
            continue;
        }
        Bridge* best = nullptr;
        double farthest = kLeast;
        for (Bridge& bridge : bridges) {
            double inside = 0.0;
            for (const std::size_t path : bridge.paths) {
                inside += length_inside(paths_[path].way->points, areas_[i].polygons);
            }
            if (inside > farthest) {
                farthest = inside;
                best = &bridge;
            }
        }
        if (best != nullptr) {
            best->outlines.push_back(i);
        }
    }
}

double BridgeNetwork::layer(const Bridge& bridge) const {
    double highest = 0.0;
    for (const std::size_t i : bridge.paths) {
        highest = std::max(highest, layer_of(paths_[i].way->tags));
    }
    return highest;
}

std::unordered_map<std::int64_t, double> BridgeNetwork::distances_from(std::int64_t start,
                                                                       const Bridge& bridge) const {
    std::unordered_map<std::int64_t, std::vector<std::pair<std::int64_t, double>>> edges;
    for (const std::size_t number : bridge.paths) {
        const MapWay& way = *paths_[number].way;
        for (std::size_t i = 1; i < way.nodes.size(); ++i) {
            const double length = (way.points[i] - way.points[i - 1]).norm();
            edges[way.nodes[i]].emplace_back(way.nodes[i - 1], length);
            edges[way.nodes[i - 1]].emplace_back(way.nodes[i], length);
        }
    }
    std::unordered_map<std::int64_t, double> distances;
    std::priority_queue<std::pair<double, std::int64_t>, std::vector<std::pair<double, std::int64_t>>,
                        std::greater<>>
        open;
    open.emplace(0.0, start);
    while (!open.empty()) {
        const auto [distance, node] = open.top();
        open.pop();
        if (!distances.try_emplace(node, distance).second) {
            continue;
        }
        for (const auto& [next, length] : edges[node]) {
            open.emplace(distance + length, next);
        }
    }
    return distances;
}

}  // namespace campuswalk::scene::osm
