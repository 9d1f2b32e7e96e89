#include "engine/render/snapshot/walk_space_lines.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "engine/script/walk.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/report/walk_report.h"

namespace campuswalk::engine::render {

using Eigen::Vector3d;

namespace {

constexpr std::array<float, 3> kReached = {0.05F, 0.85F, 0.25F};
constexpr double kAboveGround = 0.05;  // metres
constexpr std::size_t kMostNodes = 4'000'000;
constexpr double kHalfDot = 0.04;  // metres
/// Ground in the next cell belongs to this one's up to this height apart, metres.
constexpr double kSameGround = 0.4;

WalkSpace explored(const scene::Campus& campus, const WalkSpaceRequest& request) {
    ExploreSettings settings = explore_settings(campus, request.profile, SimSettings().ticks_per_second);
    settings.solids.disabled = request.disabled;
    settings.starts = request.starts;
    settings.max_nodes = kMostNodes;
    if (request.radius > 0.0 && !request.starts.empty()) {
        const Vector3d around(request.radius, campus.world.bounds().max.y() - campus.world.bounds().min.y(),
                              request.radius);
        settings.within = {request.starts.front() - around, request.starts.front() + around};
    }
    return explore(WorkerWorlds(campus.world, 1, {}), settings);
}

void add_cell(const WalkSpace& space, const WalkNodeId& node, std::vector<OverlayLine>& lines) {
    const GridCell cell = space.cell_of(node);
    const Vector3d middle = space.position(node) + kAboveGround * Vector3d::UnitY();
    for (const auto& [dx, dz] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        const auto beside = space.find({cell.x + dx, cell.z + dz}, middle.y(), kSameGround);
        if (!beside || space.node(*beside).hangs != 0) {
            const Vector3d side = 0.5 * space.grid.cell * Vector3d(dx, 0, dz);
            const Vector3d along = 0.5 * space.grid.cell * Vector3d(dz, 0, dx);
            lines.push_back({middle + side - along, middle + side + along, kReached});
        }
    }
    if (cell.x % 2 == 0 && cell.z % 2 == 0) {
        const Vector3d half = kHalfDot * Vector3d::UnitX();
        lines.push_back({middle - half, middle + half, kReached});
    }
}

}  // namespace

void add_walk_space(const scene::Campus& campus, const WalkSpaceRequest& request,
                    std::vector<OverlayLine>& lines) {
    const WalkSpace space = explored(campus, request);
    for (std::uint32_t t = 0; t < space.tiles.size(); ++t) {
        for (std::size_t n = 0; n < space.tiles[t].nodes.size(); ++n) {
            if (space.tiles[t].nodes[n].hangs == 0) {
                add_cell(space, {t, static_cast<std::uint16_t>(n)}, lines);
            }
        }
    }
}

}  // namespace campuswalk::engine::render
