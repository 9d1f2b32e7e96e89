#include "tools/campuswalk_bench/peers/recast_tiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <thread>
#include <utility>

#include <Eigen/Geometry>

namespace campuswalk::tools::bench {

namespace {

/// Cells along a tile without its border: few enough for the processor's cache, many enough for the border
/// not to matter.
constexpr int kTileCells = 256;

}  // namespace

void require(bool done) {
    if (!done) {
        throw std::runtime_error("Recast failed");
    }
}

NavTiles::NavTiles(const collision::TriangleMesh& mesh, const NavMeshSettings& settings)
    : threads_(settings.threads) {
    for (const Eigen::Vector3f& p : mesh.positions) {
        positions_.insert(positions_.end(), {p.x(), p.y(), p.z()});
    }
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t vertex : t) {
            triangles_.push_back(static_cast<int>(vertex));
        }
    }
    rcCalcBounds(positions_.data(), vertex_count(), low_, high_);
    rcConfig& c = config_;
    const WalkBody& body = settings.body;
    constexpr double kRounding = 1e-6;
    const auto up = [](double cells) { return static_cast<int>(std::ceil(cells - kRounding)); };
    c.cs = static_cast<float>(settings.cell);
    c.ch = static_cast<float>(settings.cell_height);
    c.walkableSlopeAngle = static_cast<float>(body.max_slope * 57.29577951308232);
    c.walkableHeight = up(body.height / settings.cell_height);
    c.walkableClimb = static_cast<int>(std::floor(body.step_height / settings.cell_height + kRounding));
    c.walkableRadius = up(body.radius / settings.cell);
    // The sample's settings.
    c.maxEdgeLen = static_cast<int>(12.0 / settings.cell);
    c.maxSimplificationError = 1.3F;
    c.minRegionArea = 8 * 8;
    c.mergeRegionArea = 20 * 20;
    c.maxVertsPerPoly = DT_VERTS_PER_POLYGON;
    c.detailSampleDist = 6.0F * c.cs;
    c.detailSampleMaxError = c.ch;
    c.tileSize = kTileCells;
    c.borderSize = c.walkableRadius + 3;
    c.width = c.height = c.tileSize + 2 * c.borderSize;
}

void NavTiles::build() {
    divide();
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < tiles_.size(); i = next++) {
                build_tile(tiles_[i]);
            }
        } catch (const std::exception&) {
            failed = true;
        }
    };
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < threads_; ++i) {
        others.emplace_back(work);
    }
    work();
    for (std::thread& other : others) {
        other.join();
    }
    require(!failed);
}

/// Which triangles each tile sees, with its border.
void NavTiles::divide() {
    const float size = config_.cs * static_cast<float>(config_.tileSize);
    const float border = config_.cs * static_cast<float>(config_.borderSize);
    const int columns = static_cast<int>((high_[0] - low_[0]) / size) + 1;
    const int rows = static_cast<int>((high_[2] - low_[2]) / size) + 1;
    tiles_.clear();
    tiles_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int z = 0; z < rows; ++z) {
        for (int x = 0; x < columns; ++x) {
            NavTile& tile = tiles_[static_cast<std::size_t>(x + columns * z)];
            tile.x = x;
            tile.z = z;
        }
    }
    for (std::size_t t = 0; t < triangles_.size(); t += 3) {
        const auto range = [&](int axis, int count) {
            const auto of = [&](std::size_t vertex) {
                return positions_[3 * static_cast<std::size_t>(triangles_[t + vertex]) +
                                  static_cast<std::size_t>(axis)] -
                       low_[axis];
            };
            const auto [low, high] = std::minmax({of(0), of(1), of(2)});
            return std::pair(std::max(0, static_cast<int>(std::floor((low - border) / size))),
                             std::min(count - 1, static_cast<int>(std::floor((high + border) / size))));
        };
        const auto [x_low, x_high] = range(0, columns);
        const auto [z_low, z_high] = range(2, rows);
        for (int z = z_low; z <= z_high; ++z) {
            for (int x = x_low; x <= x_high; ++x) {
                std::vector<int>& seen = tiles_[static_cast<std::size_t>(x + columns * z)].triangles;
                seen.insert(seen.end(), &triangles_[t], &triangles_[t] + 3);
            }
        }
    }
}

rcConfig NavTiles::config_of(const NavTile& tile) const {
    rcConfig c = config_;
    const float size = c.cs * static_cast<float>(c.tileSize);
    const float border = c.cs * static_cast<float>(c.borderSize);
    const float x = low_[0] + static_cast<float>(tile.x) * size;
    const float z = low_[2] + static_cast<float>(tile.z) * size;
    rcVcopy(c.bmin, low_);
    rcVcopy(c.bmax, high_);
    c.bmin[0] = x - border;
    c.bmin[2] = z - border;
    c.bmax[0] = x + size + border;
    c.bmax[2] = z + size + border;
    return c;
}

/// As rcMarkWalkableTriangles would, but for triangles that face down: a model may have a floor of them, on
/// which our body walks as well.
std::vector<unsigned char> NavTiles::areas_of(const NavTile& tile) const {
    const auto vertex = [&](std::size_t i) {
        return Eigen::Map<const Eigen::Vector3f>(
            &positions_[3 * static_cast<std::size_t>(tile.triangles[i])]);
    };
    const float least = std::cos(config_.walkableSlopeAngle * 0.017453292F);
    std::vector<unsigned char> areas;
    for (std::size_t t = 0; t < tile.triangles.size(); t += 3) {
        const Eigen::Vector3f normal = (vertex(t + 1) - vertex(t)).cross(vertex(t + 2) - vertex(t));
        areas.push_back(std::abs(normal.y()) > least * normal.norm() ? RC_WALKABLE_AREA : RC_NULL_AREA);
    }
    return areas;
}

Owned<rcHeightfield> NavTiles::rasterize(rcContext& context, const rcConfig& c, const NavTile& tile) const {
    Owned<rcHeightfield> solid(rcAllocHeightfield());
    require(solid && rcCreateHeightfield(&context, *solid, c.width, c.height, c.bmin, c.bmax, c.cs, c.ch));
    const std::vector<unsigned char> areas = areas_of(tile);
    const int count = static_cast<int>(areas.size());
    require(rcRasterizeTriangles(&context, positions_.data(), vertex_count(), tile.triangles.data(),
                                 areas.data(), count, *solid, c.walkableClimb));
    rcFilterLowHangingWalkableObstacles(&context, c.walkableClimb, *solid);
    rcFilterLedgeSpans(&context, c.walkableHeight, c.walkableClimb, *solid);
    rcFilterWalkableLowHeightSpans(&context, c.walkableHeight, *solid);
    return solid;
}

void NavTiles::build_tile(NavTile& tile) const {
    if (tile.triangles.empty()) {
        return;
    }
    rcContext context(false);
    const rcConfig c = config_of(tile);
    Owned<rcHeightfield> solid = rasterize(context, c, tile);
    const Owned<rcCompactHeightfield> open(rcAllocCompactHeightfield());
    require(open && rcBuildCompactHeightfield(&context, c.walkableHeight, c.walkableClimb, *solid, *open));
    solid.reset();
    require(rcErodeWalkableArea(&context, c.walkableRadius, *open));
    require(rcBuildDistanceField(&context, *open));
    require(rcBuildRegions(&context, *open, c.borderSize, c.minRegionArea, c.mergeRegionArea));
    const Owned<rcContourSet> contours(rcAllocContourSet());
    require(contours && rcBuildContours(&context, *open, c.maxSimplificationError, c.maxEdgeLen, *contours));
    if (contours->nconts == 0) {
        return;
    }
    tile.polygons.reset(rcAllocPolyMesh());
    require(tile.polygons && rcBuildPolyMesh(&context, *contours, c.maxVertsPerPoly, *tile.polygons));
    tile.detail.reset(rcAllocPolyMeshDetail());
    require(tile.detail && rcBuildPolyMeshDetail(&context, *tile.polygons, *open, c.detailSampleDist,
                                                 c.detailSampleMaxError, *tile.detail));
}

}  // namespace campuswalk::tools::bench
