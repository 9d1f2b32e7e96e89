#include "engine/walkspace/tile_order.h"

#include <optional>

namespace campuswalk::engine {

namespace {

/// Tiles side by side never have the same.
std::size_t color_of(const WalkTile& tile) {
    const auto parity = [](int first_cell) {
        return static_cast<std::size_t>((first_cell / WalkTile::kCells) & 1);
    };
    return parity(tile.first_cell.x) + 2 * parity(tile.first_cell.z);
}

}  // namespace

TileOrder order_around(const std::vector<std::uint32_t>& tiles, const WalkSpace& space) {
    std::vector<bool> chosen(space.tiles.size(), false);
    for (const std::uint32_t tile : tiles) {
        for (const std::uint32_t beside : space.tiles[tile].neighbours) {  // itself, too
            if (beside != WalkTile::kNoTile) {
                chosen[beside] = true;
            }
        }
    }
    TileOrder order;
    std::vector<std::optional<std::size_t>> index_of(space.tiles.size());
    for (std::size_t color = 0; color < 4; ++color) {
        for (std::uint32_t tile = 0; tile < space.tiles.size(); ++tile) {
            if (!chosen[tile] || color_of(space.tiles[tile]) != color) {
                continue;
            }
            order.after.emplace_back();
            for (const std::uint32_t beside : space.tiles[tile].neighbours) {
                if (beside != WalkTile::kNoTile && index_of[beside]) {
                    order.after.back().push_back(*index_of[beside]);
                }
            }
            index_of[tile] = order.tiles.size();
            order.tiles.push_back(tile);
        }
    }
    return order;
}

}  // namespace campuswalk::engine
