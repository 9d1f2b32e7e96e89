#include "engine/walkspace/explore/known_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/script/travel.h"

namespace campuswalk::engine {

using collision::Vec3;

KnownCells::KnownCells(const ExploreSettings& settings, const GoalPolicy& policy, const WalkSpace& space,
                       const std::vector<Frontier>& frontiers)
    : settings_(settings),
      policy_(policy),
      space_(space),
      frontiers_(frontiers),
      most_rise_(settings.strides.body.steepest_rise() * space.grid.cell / kDiagonal) {}

bool KnownCells::has(const GridCell& cell, double y, bool hangs, std::uint32_t tile) const {
    if (settings_.knows(cell, y)) {
        return true;
    }
    const WalkTile& own = space_.tiles[tile];
    const std::size_t side = own.side_of(cell);
    const std::uint32_t number = own.neighbours[side];
    if (number != WalkTile::kNoTile) {
        const WalkTile& other = space_.tiles[number];
        if (other.has(other.index_of(cell), y, hangs)) {
            return true;
        }
    }
    if (policy_.leads_to_point() || side == 4) {
        return false;
    }
    if (number != WalkTile::kNoTile) {
        return frontiers_[tile].has_sent(cell, y, hangs);
    }
    // Where there is no tile yet, what those around have sent is still with them.
    return std::ranges::any_of(own.neighbours, [&](std::uint32_t around) {
        return around != WalkTile::kNoTile && frontiers_[around].has_sent(cell, y, hangs);
    });
}

bool KnownCells::has_ahead(const GridCell& ahead, const GridCell& behind, double y,
                           std::uint32_t tile) const {
    const auto before = level_in(behind, y, most_rise_, tile);
    return before && level_in(ahead, 2.0 * y - *before, WalkNode::kLevel, tile);
}

bool KnownCells::has_all_near(const Vec3& foot, double metres, bool hangs, std::uint32_t tile) const {
    const GridCell first = space_.grid.cell_at(foot.x() - metres, foot.z() - metres);
    const GridCell last = space_.grid.cell_at(foot.x() + metres, foot.z() + metres);
    for (int z = first.z; z <= last.z; ++z) {
        for (int x = first.x; x <= last.x; ++x) {
            const Vec3 to_middle = flat(space_.grid.center({x, z}) - foot);
            const Vec3 to_cell = (to_middle.cwiseAbs() - 0.5 * space_.grid.cell * Vec3::Ones()).cwiseMax(0.0);
            if (collision::horizontal_norm(to_cell) <= metres && !has({x, z}, foot.y(), hangs, tile)) {
                return false;
            }
        }
    }
    return true;
}

std::optional<double> KnownCells::ground_ahead(const Vec3& foot, std::uint8_t direction, double metres,
                                               std::uint32_t tile) const {
    const GridDirection& to = grid_directions()[direction];
    const bool is_diagonal = to.x != 0 && to.z != 0;
    const std::array<GridCell, 3> beside =
        is_diagonal ? std::array<GridCell, 3>{{{0, 0}, {-to.x, 0}, {0, -to.z}}}
                    : std::array<GridCell, 3>{{{0, 0}, {to.z, to.x}, {-to.z, -to.x}}};
    const double length = is_diagonal ? space_.grid.cell / kDiagonal : space_.grid.cell;
    const int count = static_cast<int>(std::ceil(metres / length));
    if (count >= WalkTile::kCells) {
        return std::nullopt;
    }
    const GridCell first = space_.grid.cell_at(foot);
    double lowest = foot.y();
    for (const GridCell& shift : beside) {
        double y = foot.y();
        for (int i = 1; i <= count; ++i) {
            const auto level =
                level_in({first.x + i * to.x + shift.x, first.z + i * to.z + shift.z}, y, most_rise_, tile);
            if (!level) {
                return std::nullopt;
            }
            y = *level;
            lowest = std::min(lowest, y);
        }
    }
    return lowest;
}

/// The height of the cell's node nearest to a height; the cell is in the tile or beside it.
std::optional<double> KnownCells::level_in(const GridCell& cell, double y, double tolerance,
                                           std::uint32_t tile) const {
    const WalkTile& own = space_.tiles[tile];
    const std::uint32_t number = own.neighbours[own.side_of(cell)];
    if (number != WalkTile::kNoTile) {
        const WalkTile& other = space_.tiles[number];
        const auto node = other.find(other.index_of(cell), y, tolerance);
        return node ? std::optional<double>(other.nodes[*node].y) : std::nullopt;
    }
    std::optional<double> level;
    for (const std::uint32_t around : own.neighbours) {
        if (around != WalkTile::kNoTile && !policy_.leads_to_point()) {
            if (const auto sent = frontiers_[around].level_sent(cell, y, tolerance)) {
                level = sent;
                tolerance = std::abs(*sent - y);
            }
        }
    }
    return level;
}

}  // namespace campuswalk::engine
