#include "engine/walkspace/explore/tile_order.h"

#include <algorithm>
#include <optional>

namespace campuswalk::engine {

namespace {

/// Ascending.
std::vector<std::uint32_t> with_those_beside(const std::vector<std::uint32_t>& tiles,
                                             const WalkSpace& space) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t tile : tiles) {
        for (const std::uint32_t beside : space.tiles[tile].neighbours) {  // itself, too
            if (beside != WalkTile::kNoTile) {
                all.push_back(beside);
            }
        }
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

TileOrder order_around(const std::vector<std::uint32_t>& active, const WalkSpace& space,
                       const std::function<std::uint32_t(std::uint32_t tile)>& rank_of) {
    TileOrder order;
    order.tiles = with_those_beside(active, space);
    std::ranges::stable_sort(order.tiles, {}, rank_of);
    order.after.resize(order.tiles.size());
    std::vector<std::optional<std::size_t>> index_of(space.tiles.size());
    for (std::size_t i = 0; i < order.tiles.size(); ++i) {
        for (const std::uint32_t beside : space.tiles[order.tiles[i]].neighbours) {
            if (beside != WalkTile::kNoTile && index_of[beside]) {
                order.after[i].push_back(*index_of[beside]);
            }
        }
        index_of[order.tiles[i]] = i;
    }
    return order;
}

}  // namespace campuswalk::engine
