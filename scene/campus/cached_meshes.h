#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/base/content_hash.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/tree_file.h"
#include "scene/campus/campus_description.h"
#include "scene/campus/collider_shapes.h"

namespace campuswalk::scene {

/// The collision meshes of a campus in the order in which they are made: from the cache if they were made
/// before of the same models and nodes, and kept there if not.
class CachedMeshes {
public:
    /// Without a cache: nothing is found and nothing kept.
    CachedMeshes() = default;
    /// `origin`: what is taken off the models' coordinates; `models`: what each of them is made of (see
    /// load_model.h).
    CachedMeshes(const CacheFolder& cache, const CampusDescription& campus, const Eigen::Vector3d& origin,
                 std::span<const ContentHash> models);

    /// The one whose turn it is; nullopt if it has to be made, and then given to `add`.
    std::optional<PlacedShape> next();
    void add(const PlacedShape& made);
    /// To be called once all have been made without a mistake.
    void keep() const;

private:
    const CacheFolder* cache_ = nullptr;
    ContentHash key_;
    std::vector<PlacedMesh> meshes_;  ///< found in the cache, then those made
    std::size_t taken_ = 0;           ///< of those found
    bool complete_ = true;            ///< nothing had to be made
};

}  // namespace campuswalk::scene
