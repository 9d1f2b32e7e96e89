#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "collision/mover/mover_settings.h"
#include "collision/world/world.h"
#include "engine/walkspace/stride/walk_grid.h"

namespace campuswalk::engine {

/// Where a body has room to stand, by geometry alone: what ways are guessed by before they are walked. Spots
/// are found as they are asked for, and kept, which changes no answer.
class GroundMap {
public:
    /// A surface within a cell. Numbered in its tile, cell by cell from low to high.
    struct Spot {
        std::uint32_t tile = 0;
        std::uint32_t number = 0;

        friend bool operator==(const Spot&, const Spot&) = default;
    };
    /// Of one cell.
    struct Spots {
        std::uint32_t tile = 0;
        std::uint32_t first = 0;
        std::uint32_t end = 0;
    };

    /// The world must outlive it.
    GroundMap(const collision::World& world, const collision::MoverSettings& body,
              const collision::QueryFilter& filter);

    /// Whether it was made for exactly these.
    bool is_for(const collision::World& world, const collision::MoverSettings& body,
                const collision::QueryFilter& filter) const;

    const WalkGrid& grid() const { return grid_; }
    Spots spots_in(const GridCell& cell);
    /// All of them, in this tile.
    std::size_t count(std::uint32_t tile) const { return tiles_[tile]->levels.size(); }
    /// The height of the surface.
    double height(const Spot& spot) const { return level(spot).y; }
    /// The middle of the cell or, where the body has no room there, a point beside it that it has room at.
    collision::Vec3 foot(const Spot& spot) const;
    /// Whether the body has room on the surface, or above what it could climb from there.
    bool has_room(const Spot& spot);
    /// Whether it has `beside` metres more than the room that it needs, there. Likewise only above what it
    /// could climb.
    bool has_room_beside(const collision::Vec3& foot, double beside) const;
    /// Whether it has room all the way from one foot to another, `beside` metres more than itself. Only above
    /// what it could climb, and 15 cm.
    bool is_path_free(const collision::Vec3& from, const collision::Vec3& to, double beside) const;

private:
    static constexpr int kCells = 32;  ///< along a tile

    enum class Room : std::uint8_t { unknown, none, here };
    struct Level {
        float y = 0.0F;
        Room room = Room::unknown;
        std::uint8_t offset = 0;  ///< number of the point in the cell
        std::uint16_t cell = 0;   ///< its index in the tile
    };
    struct Tile {
        /// x + kCells * z in the tile.
        int index_of(const GridCell& cell) const {
            return cell.x - first_cell.x + kCells * (cell.z - first_cell.z);
        }

        GridCell first_cell;
        std::array<std::uint32_t, kCells* kCells + 1> first = {};  ///< level of each cell
        std::vector<Level> levels;
    };

    std::uint32_t tile_of(const GridCell& first_cell);
    void fill(Tile& tile) const;
    /// `levels`: by cell, from low to high.
    static void drop_covered(std::vector<Level>& levels);
    const Level& level(const Spot& spot) const { return tiles_[spot.tile]->levels[spot.number]; }
    /// Number of the first point at which the body has room.
    std::optional<std::uint8_t> free_point(const Tile& tile, const Level& level) const;
    collision::Vec3 point_at(const Tile& tile, const Level& level, std::uint8_t offset) const;

    const collision::World& world_;
    collision::MoverSettings body_;
    double lift_;  ///< of the feet above the ground, for a body that climbs what is lower
    std::vector<bool> disabled_;
    collision::QueryFilter filter_;
    WalkGrid grid_;
    std::vector<std::unique_ptr<Tile>> tiles_;
    std::uint32_t latest_ = 0;  ///< number of the tile that was asked for last: likely to be asked for next
    std::unordered_map<GridCell, std::uint32_t, GridCellHash> numbers_;  ///< of tiles, by their first cells
};

/// The maps of a few bodies among some solids, for routes that are planned one after another.
class GroundMaps {
public:
    /// Valid until the next call.
    GroundMap& of(const collision::World& world, const collision::MoverSettings& body,
                  const collision::QueryFilter& filter);

private:
    std::vector<std::unique_ptr<GroundMap>> maps_;  ///< the one that was asked for last comes last
};

}  // namespace campuswalk::engine
