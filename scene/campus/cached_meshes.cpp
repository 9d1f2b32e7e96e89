#include "scene/campus/cached_meshes.h"

#include <memory>
#include <utility>
#include <variant>

#include "scene/cache/program_hash.h"
#include "scene/campus/collider_globs.h"

namespace campuswalk::scene {
namespace {

constexpr const char* kTreesKind = "trees";

void add_globs(const std::vector<NodeGlob>& globs, ContentHasher& hasher) {
    hasher.add_number(std::uint64_t{globs.size()});
    for (const NodeGlob& glob : globs) {
        hasher.add_text(glob.pattern);
    }
}

/// Of everything that decides over the meshes and their order.
ContentHash key_of(const CampusDescription& campus, const Eigen::Vector3d& origin,
                   std::span<const ContentHash> models) {
    ContentHasher hasher;
    hasher.add_hash(program_hash());
    hasher.add_number(std::uint64_t{kTreeFile.version});
    hasher.add_number(std::uint64_t{models.size()});
    for (const ContentHash& model : models) {
        hasher.add_hash(model);
    }
    for (const double along : origin) {
        hasher.add_number(along);
    }
    for (const ColliderDescription& collider : campus.colliders) {
        if (std::holds_alternative<MeshShape>(collider.shape)) {
            hasher.add_number(std::uint64_t{collider.each});
            add_globs(globs_of(campus, collider), hasher);
            add_globs(collider.except, hasher);
        }
    }
    return hasher.result();
}

}  // namespace

CachedMeshes::CachedMeshes(const CacheFolder& cache, const CampusDescription& campus,
                           const Eigen::Vector3d& origin, std::span<const ContentHash> models)
    : cache_(&cache), key_(key_of(campus, origin, models)) {
    if (const auto file = cache.find(key_, kTreesKind)) {
        try {
            meshes_ = read_tree_file(file->bytes(), file);
        } catch (const DamagedFile&) {  // to be made anew
        }
    }
}

std::optional<PlacedShape> CachedMeshes::next() {
    if (!complete_ || taken_ == meshes_.size()) {
        complete_ = false;
        return std::nullopt;
    }
    const PlacedMesh& mesh = meshes_[taken_++];
    PlacedShape placed;
    placed.shape = mesh.collider;
    placed.X_world_shape.translation = mesh.p_world_origin;
    placed.zero_area = mesh.zero_area;
    return placed;
}

void CachedMeshes::add(const PlacedShape& made) {
    if (cache_ != nullptr) {
        meshes_.push_back({std::get<std::shared_ptr<const collision::MeshCollider>>(made.shape),
                           made.X_world_shape.translation, made.zero_area});
    }
}

void CachedMeshes::keep() const {
    if (cache_ != nullptr && !complete_) {
        ArchiveWriter trees = archive_trees(meshes_);
        cache_->store(key_, kTreesKind, trees.finish());
    }
}

}  // namespace campuswalk::scene
