// Recast's navigation mesh, and Detour's links between its polygons.

#include <recastnavigation/DetourNavMeshBuilder.h>

#include <algorithm>
#include <utility>

#include "tools/campuswalk_bench/peers/recast_tiles.h"

namespace campuswalk::tools::bench {

using collision::Triangle;
using collision::Vec3;

namespace {

class Recast final : public NavMeshEngine {
public:
    Recast(const collision::TriangleMesh& mesh, const NavMeshSettings& settings)
        : body_(settings.body), tiles_(mesh, settings) {}

    void build() override {
        query_.reset();
        links_.reset();
        tiles_.build();
    }

    void reachable_from(const Vec3& foot, std::vector<Triangle>& out) override {
        out.clear();
        link();
        for (const dtPolyRef polygon : linked_to(nearest(foot).polygon)) {
            add_triangles(polygon, out);
        }
    }

    bool path(const Vec3& from, const Vec3& to, std::vector<Vec3>& out) override {
        out.clear();
        link();
        const Nearest first = nearest(from);
        const Nearest last = nearest(to);
        if (first.polygon == 0 || last.polygon == 0) {
            return false;
        }
        constexpr int kMost = 4096;
        polygons_.resize(kMost);
        int count = 0;
        query_->findPath(first.polygon, last.polygon, first.point, last.point, &filter_, polygons_.data(),
                         &count, kMost);
        if (count == 0 || polygons_[static_cast<std::size_t>(count) - 1] != last.polygon) {
            return false;
        }
        vertices_.resize(3 * kMost);
        int vertices = 0;
        query_->findStraightPath(first.point, last.point, polygons_.data(), count, vertices_.data(), nullptr,
                                 nullptr, &vertices, kMost);
        for (int i = 0; i < vertices; ++i) {
            out.push_back(Eigen::Map<const Eigen::Vector3f>(&vertices_[3 * static_cast<std::size_t>(i)])
                              .cast<double>());
        }
        return !out.empty();
    }

private:
    struct Nearest {
        dtPolyRef polygon = 0;  ///< 0: none
        float point[3] = {};
    };

    Nearest nearest(const Vec3& foot) const {
        const float at[3] = {static_cast<float>(foot.x()), static_cast<float>(foot.y()),
                             static_cast<float>(foot.z())};
        const float reach[3] = {1.0F, 1.0F, 1.0F};
        Nearest found;
        query_->findNearestPoly(at, reach, &filter_, &found.polygon, found.point);
        return found;
    }

    /// Makes Detour's mesh from the tiles, unless that was done since they were built.
    void link() {
        if (links_) {
            return;
        }
        links_.reset(dtAllocNavMesh());
        const auto bits_for = [](std::size_t count) {
            int bits = 1;
            while ((std::size_t{1} << bits) < count) {
                ++bits;
            }
            return bits;
        };
        const int tile_bits = bits_for(tiles_.tiles().size());
        dtNavMeshParams params{};
        rcVcopy(params.orig, tiles_.low());
        params.tileWidth = params.tileHeight =
            tiles_.config().cs * static_cast<float>(tiles_.config().tileSize);
        params.maxTiles = 1 << tile_bits;
        params.maxPolys = 1 << (22 - tile_bits);
        require(links_ && dtStatusSucceed(links_->init(&params)));
        for (const NavTile& tile : tiles_.tiles()) {
            if (tile.polygons && tile.polygons->npolys > 0) {
                add(tile);
            }
        }
        constexpr int kMostSearchNodes = 65535;
        query_.reset(dtAllocNavMeshQuery());
        require(query_ && dtStatusSucceed(query_->init(links_.get(), kMostSearchNodes)));
    }

    void add(const NavTile& tile) {
        rcPolyMesh& mesh = *tile.polygons;
        std::fill(mesh.flags, mesh.flags + mesh.npolys, static_cast<unsigned short>(1));
        dtNavMeshCreateParams params{};
        params.verts = mesh.verts;
        params.vertCount = mesh.nverts;
        params.polys = mesh.polys;
        params.polyAreas = mesh.areas;
        params.polyFlags = mesh.flags;
        params.polyCount = mesh.npolys;
        params.nvp = mesh.nvp;
        params.detailMeshes = tile.detail->meshes;
        params.detailVerts = tile.detail->verts;
        params.detailVertsCount = tile.detail->nverts;
        params.detailTris = tile.detail->tris;
        params.detailTriCount = tile.detail->ntris;
        params.walkableHeight = static_cast<float>(body_.height);
        params.walkableRadius = static_cast<float>(body_.radius);
        params.walkableClimb = static_cast<float>(body_.step_height);
        params.tileX = tile.x;
        params.tileY = tile.z;
        rcVcopy(params.bmin, mesh.bmin);
        rcVcopy(params.bmax, mesh.bmax);
        params.cs = tiles_.config().cs;
        params.ch = tiles_.config().ch;
        params.buildBvTree = true;
        unsigned char* data = nullptr;
        int size = 0;
        require(dtCreateNavMeshData(&params, &data, &size));
        require(dtStatusSucceed(links_->addTile(data, size, DT_TILE_FREE_DATA, 0, nullptr)));
    }

    std::vector<dtPolyRef> linked_to(dtPolyRef first) const {
        std::vector<dtPolyRef> found;
        if (first == 0) {
            return found;
        }
        const dtNavMesh& mesh = *links_;
        std::vector<dtPolyRef> known{first};
        found.push_back(first);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const dtMeshTile* tile = nullptr;
            const dtPoly* polygon = nullptr;
            mesh.getTileAndPolyByRefUnsafe(found[i], &tile, &polygon);
            for (unsigned int k = polygon->firstLink; k != DT_NULL_LINK; k = tile->links[k].next) {
                const dtPolyRef other = tile->links[k].ref;
                const auto at = std::lower_bound(known.begin(), known.end(), other);
                if (other != 0 && (at == known.end() || *at != other)) {
                    known.insert(at, other);
                    found.push_back(other);
                }
            }
        }
        return found;
    }

    void add_triangles(dtPolyRef ref, std::vector<Triangle>& out) const {
        const dtMeshTile* tile = nullptr;
        const dtPoly* polygon = nullptr;
        std::as_const(*links_).getTileAndPolyByRefUnsafe(ref, &tile, &polygon);
        const dtPolyDetail& detail = tile->detailMeshes[polygon - tile->polys];
        for (unsigned int i = 0; i < detail.triCount; ++i) {
            const unsigned char* vertices = &tile->detailTris[4 * (detail.triBase + i)];
            const auto at = [&](unsigned char vertex) {
                const float* v =
                    vertex < polygon->vertCount
                        ? &tile->verts[3 * polygon->verts[vertex]]
                        : &tile->detailVerts[3 * (detail.vertBase + vertex - polygon->vertCount)];
                return Eigen::Vector3f(v[0], v[1], v[2]).cast<double>().eval();
            };
            out.push_back({at(vertices[0]), at(vertices[1]), at(vertices[2])});
        }
    }

    WalkBody body_;
    NavTiles tiles_;
    Owned<dtNavMesh> links_;
    Owned<dtNavMeshQuery> query_;
    dtQueryFilter filter_;
    std::vector<dtPolyRef> polygons_;
    std::vector<float> vertices_;
};

}  // namespace

extern "C" NavMeshEngine* campuswalk_make_nav_mesh_engine(const collision::TriangleMesh& mesh,
                                                          const NavMeshSettings& settings) {
    return new Recast(mesh, settings);
}

}  // namespace campuswalk::tools::bench
