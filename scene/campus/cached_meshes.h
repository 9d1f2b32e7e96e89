#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "scene/base/content_hash.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/tree_file.h"
#include "scene/campus/campus_description.h"
#include "scene/campus/collider_shapes.h"

namespace campuswalk::scene {

/// The collision meshes of a campus' objects, by the objects' ids: from the cache if they were made before of
/// the same models and nodes, and written there if not.
class CachedMeshes {
public:
    /// Without a cache: nothing is found and nothing written.
    CachedMeshes() = default;
    /// `origin`: what is taken off the models' coordinates; `models`: what each of them is made of (see
    /// load_model.h).
    CachedMeshes(const CacheFolder& cache, const CampusDescription& campus, const Eigen::Vector3d& origin,
                 std::span<const ContentHash> models);

    /// nullopt if the object's mesh has to be made, and then given to `add`.
    std::optional<PlacedShape> find(const std::string& object) const;
    void add(const std::string& object, const PlacedShape& made);
    /// Writes what was added. To be called once all have been made without a mistake.
    void keep() const;

private:
    const CacheFolder* cache_ = nullptr;
    ContentHash key_;
    std::map<std::string, PlacedMesh> meshes_;
    bool is_new_ = false;  ///< some were added
};

}  // namespace campuswalk::scene
