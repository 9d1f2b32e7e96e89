#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"
#include "scene/cache/tree_file.h"
#include "scene/campus/campus_description.h"
#include "scene/campus/collider_shapes.h"

namespace campuswalk::scene {

/// The collision meshes of a campus' objects, by the objects' ids: read from the cache if they were built
/// before from the same models and nodes, otherwise written to it.
class CachedMeshes {
public:
    /// Without a cache: nothing is found and nothing written.
    CachedMeshes() = default;
    /// `origin`: the offset subtracted from the models' coordinates; `models`: the hashes of their contents
    /// (see load_model.h).
    CachedMeshes(const CacheFolder& cache, const CampusDescription& campus, const Eigen::Vector3d& origin,
                 std::span<const ContentHash> models);

    /// nullopt if the object's mesh has to be built, and then passed to `add`.
    std::optional<PlacedShape> find(const std::string& object) const;
    void add(const std::string& object, const PlacedShape& built);
    /// Writes the added meshes to the cache. Call when all have been built without errors.
    void keep() const;

private:
    const CacheFolder* cache_ = nullptr;
    ContentHash key_;
    std::map<std::string, PlacedMesh> meshes_;
    bool is_new_ = false;  ///< some were added
};

}  // namespace campuswalk::scene
