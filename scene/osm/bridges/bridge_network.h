#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "scene/osm/bridges/bridges.h"

namespace campuswalk::scene::osm {

/// Which paths meet at which nodes, and which of them are bridges. Unbuilt paths don't count.
class BridgeNetwork {
public:
    /// Both must outlive it; the heights of paths may change meanwhile.
    BridgeNetwork(const std::vector<MapArea>& areas, const std::vector<Path>& paths);

    /// Paths, each with the place of the node in it.
    const std::vector<std::pair<std::size_t, std::size_t>>& at(std::int64_t node) const;
    /// Of the widest path at a node, metres.
    double width_at(std::int64_t node) const;

    /// Whether a path's tags put it above others.
    static bool may_be_above(const Path& path);
    /// What may be above others, those that share nodes as one; with their ends, the lowest layers first.
    std::vector<Bridge> bridges() const;
    /// Metres from a node along the paths of a bridge to all nodes of them.
    std::unordered_map<std::int64_t, double> distances_from(std::int64_t start, const Bridge& bridge) const;

private:
    Bridge connected_to(std::size_t first, std::vector<bool>& taken) const;
    void find_ends(Bridge& bridge) const;
    void find_outlines(std::vector<Bridge>& bridges) const;
    double layer(const Bridge& bridge) const;

    const std::vector<MapArea>& areas_;
    const std::vector<Path>& paths_;
    std::unordered_map<std::int64_t, std::vector<std::pair<std::size_t, std::size_t>>> at_;
    std::unordered_set<std::int64_t> walls_;  ///< nodes of buildings' walls
};

}  // namespace campuswalk::scene::osm
