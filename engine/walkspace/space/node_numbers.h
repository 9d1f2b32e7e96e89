#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// The nodes of a space, numbered from 0, tile by tile. The space must outlive it and stay as it is.
class NodeNumbers {
public:
    explicit NodeNumbers(const WalkSpace& space) : space_(space) {
        for (const WalkTile& tile : space.tiles) {
            first_.push_back(count_);
            count_ += tile.nodes.size();
        }
    }
    std::size_t count() const { return count_; }
    std::size_t operator()(const WalkNodeId& id) const { return first_[id.tile] + id.node; }

    /// Calls `visit` for each node, in the order of their numbers.
    template <typename Visit>
    void for_each(const Visit& visit) const {
        for (std::uint32_t t = 0; t < space_.tiles.size(); ++t) {
            const auto nodes = static_cast<std::uint16_t>(space_.tiles[t].nodes.size());
            for (std::uint16_t n = 0; n < nodes; ++n) {
                visit(WalkNodeId{t, n});
            }
        }
    }

private:
    const WalkSpace& space_;
    std::vector<std::size_t> first_;
    std::size_t count_ = 0;
};

}  // namespace campuswalk::engine
