#pragma once

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshQuery.h>
#include <recastnavigation/Recast.h>

#include <memory>
#include <vector>

#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// Calls Recast's and Detour's own functions that free things.
struct RecastFree {
    void operator()(rcHeightfield* p) const { rcFreeHeightField(p); }
    void operator()(rcCompactHeightfield* p) const { rcFreeCompactHeightfield(p); }
    void operator()(rcContourSet* p) const { rcFreeContourSet(p); }
    void operator()(rcPolyMesh* p) const { rcFreePolyMesh(p); }
    void operator()(rcPolyMeshDetail* p) const { rcFreePolyMeshDetail(p); }
    void operator()(dtNavMesh* p) const { dtFreeNavMesh(p); }
    void operator()(dtNavMeshQuery* p) const { dtFreeNavMeshQuery(p); }
};
template <typename T>
using Owned = std::unique_ptr<T, RecastFree>;

/// A square of the navigation mesh.
struct NavTile {
    int x = 0;
    int z = 0;
    std::vector<int> triangles;  ///< that it sees, with its border; three indices each
    Owned<rcPolyMesh> polygons;  ///< null: there is nothing to walk on
    Owned<rcPolyMeshDetail> detail;
};

/// Throws std::runtime_error unless Recast or Detour has done what it was asked.
void require(bool done);

/// Recast's part of a navigation mesh: the polygons, tile by tile as its sample makes them.
class NavTiles {
public:
    NavTiles(const collision::TriangleMesh& mesh, const NavMeshSettings& settings);

    /// In place of those built earlier.
    void build();

    const std::vector<NavTile>& tiles() const { return tiles_; }
    const rcConfig& config() const { return config_; }
    const float* low() const { return low_; }  ///< of the mesh's bounds: x, y, z

private:
    int vertex_count() const { return static_cast<int>(positions_.size() / 3); }
    void divide();
    rcConfig config_of(const NavTile& tile) const;
    std::vector<unsigned char> areas_of(const NavTile& tile) const;
    Owned<rcHeightfield> rasterize(rcContext& context, const rcConfig& c, const NavTile& tile) const;
    void build_tile(NavTile& tile) const;

    std::size_t threads_;
    std::vector<float> positions_;
    std::vector<int> triangles_;
    float low_[3] = {};
    float high_[3] = {};
    rcConfig config_{};
    std::vector<NavTile> tiles_;
};

}  // namespace campuswalk::tools::bench
