#include "engine/walkspace/passage/narrow_passages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "engine/walkspace/barrier/island_barriers.h"
#include "engine/walkspace/space/neighbour_joiner.h"
#include "engine/walkspace/space/node_numbers.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// Nodes of both bodies that differ by less in height are at one place, metres.
constexpr double kSamePlace = 0.35;
constexpr double kLeastPassedArea = 1.0;

ExploreSettings widened(ExploreSettings settings, double width) {
    collision::MoverSettings& body = settings.strides.body;
    body.radius = 0.5 * width;
    settings.keep_rim = true;
    return settings;
}

/// Beside a wall the narrow body gets this much nearer: not because of a passage.
int cells_beside(const ExploreSettings& narrow, const ExploreSettings& wide, const WalkGrid& grid) {
    const double nearer = wide.strides.body.radius - narrow.strides.body.radius;
    return static_cast<int>(std::ceil(nearer / grid.cell)) + 1;
}

bool has_near(const WalkSpace& space, const GridCell& cell, double y, int cells) {
    for (int dz = -cells; dz <= cells; ++dz) {
        for (int dx = -cells; dx <= cells; ++dx) {
            if (space.find({cell.x + dx, cell.z + dz}, y, kSamePlace)) {
                return true;
            }
        }
    }
    return false;
}

/// The nodes that the wide body doesn't get near to, one of them after another in the order of their cells.
std::vector<UnreachedSpot> spots_beyond(const WalkSpace& reached, const WalkSpace& wide, int cells) {
    std::vector<std::pair<GridCell, double>> places;
    NodeNumbers(reached).for_each([&](const WalkNodeId& id) {
        const WalkNode& node = reached.node(id);
        const GridCell cell = reached.cell_of(id);
        const auto y = static_cast<double>(node.y);
        if (node.hangs == 0 && !has_near(wide, cell, y, cells)) {
            places.emplace_back(cell, y);
        }
    });
    std::ranges::sort(places);
    std::vector<UnreachedSpot> spots;
    for (const auto& [cell, y] : places) {
        Vec3 foot = reached.grid.center(cell);
        foot.y() = y;
        spots.push_back({{foot, y}});
    }
    return spots;
}

/// Side by side, no farther apart in height than a step.
std::vector<Island> joined(const std::vector<UnreachedSpot>& spots, const WalkGrid& grid, double step) {
    collision::DisjointSets sets(spots.size());
    NeighbourJoiner joiner(sets, step);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const Vec3& foot = spots[i].at.foot;
        joiner.add(grid.cell_at(foot), foot.y(), i);
    }
    return islands_of(spots, sets, grid, kLeastPassedArea);
}

}  // namespace

std::vector<NarrowPassage> find_narrow_passages(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                                const WalkSpace& reached, double width,
                                                const scene::NodeTriangles* nodes) {
    const ExploreSettings wide = widened(settings, width);
    const WalkSpace space = explore(worlds, wide);
    const std::vector<UnreachedSpot> spots =
        spots_beyond(reached, space, cells_beside(settings, wide, reached.grid));
    const std::vector<Island> islands = joined(
        spots, reached.grid, settings.strides.body.step_height + collision::kHeightSlack + WalkNode::kLevel);
    std::vector<std::optional<Barrier>> barriers =
        find_island_barriers(worlds, wide, space, islands, islands.size(), nodes);
    std::vector<NarrowPassage> passages;
    for (std::size_t i = 0; i < islands.size(); ++i) {
        if (barriers[i] && barriers[i]->kind == ReasonKind::opening) {
            barriers[i]->parts.clear();  // without the wall it would be wide enough as well
        }
        passages.push_back({islands[i], std::move(barriers[i])});
    }
    return passages;
}

}  // namespace campuswalk::engine
