#include "scene/campus/cached_meshes.h"

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "scene/cache/file_hash.h"
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

/// The hash of everything that the meshes depend on.
ContentHash key_of(const CacheFolder& cache, const CampusDescription& campus, const Eigen::Vector3d& origin,
                   std::span<const ContentHash> models) {
    ContentHasher hasher;
    hasher.add_hash(program_hash(&cache));
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
            hasher.add_text(collider.id);
            hasher.add_number(std::uint64_t{collider.each});
            hasher.add_number(std::uint64_t{is_only_trigger(collider.modes)});
            add_globs(globs_of(campus, collider), hasher);
            add_globs(collider.except, hasher);
        }
    }
    return hasher.result();
}

}  // namespace

CachedMeshes::CachedMeshes(const CacheFolder& cache, const CampusDescription& campus,
                           const Eigen::Vector3d& origin, std::span<const ContentHash> models)
    : cache_(&cache), key_(key_of(cache, campus, origin, models)) {
    if (const auto file = cache.find(key_, kTreesKind)) {
        try {
            for (PlacedMesh& mesh : read_tree_file(file->bytes(), file)) {
                std::string object = mesh.object;
                meshes_.emplace(std::move(object), std::move(mesh));
            }
        } catch (const DamagedFile&) {  // the meshes are built again
        }
    }
}

std::optional<PlacedShape> CachedMeshes::find(const std::string& object) const {
    const auto found = meshes_.find(object);
    if (found == meshes_.end()) {
        return std::nullopt;
    }
    PlacedShape placed;
    placed.shape = found->second.collider;
    placed.X_world_shape.translation = found->second.p_world_origin;
    placed.zero_area = found->second.zero_area;
    placed.openings = found->second.openings;
    placed.left_out = found->second.left_out;
    return placed;
}

void CachedMeshes::add(const std::string& object, const PlacedShape& built) {
    if (cache_ != nullptr) {
        meshes_.insert_or_assign(
            object,
            PlacedMesh{object, std::get<std::shared_ptr<const collision::MeshCollider>>(built.shape),
                       built.X_world_shape.translation, built.zero_area, built.openings, built.left_out});
        is_new_ = true;
    }
}

void CachedMeshes::keep() const {
    if (!is_new_) {
        return;
    }
    std::vector<PlacedMesh> meshes;
    meshes.reserve(meshes_.size());
    for (const auto& [object, mesh] : meshes_) {
        meshes.push_back(mesh);
    }
    ArchiveWriter trees = archive_trees(meshes);
    cache_->store(key_, kTreesKind, trees.finish());
}

}  // namespace campuswalk::scene
