#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision/world/world.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"
#include "scene/campus/campus_description.h"
#include "scene/campus/node_selection.h"
#include "scene/import/import_model.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// An object of the collision world under the name that events use. `objects[i]` is ObjectId i.
struct CampusObject {
    std::string id;
    SourceMark mark;                      ///< the collider it came from
    std::optional<std::size_t> building;  ///< index into CampusDescription::buildings
    bool popup = false;
    PopupRule popup_rule = {};
    NodeSelection nodes = {};  ///< that its geometry comes from
};

/// A node whose triangles were taken out of its model: see remove_open_doors.
struct RemovedNode {
    NodeRef node;
    std::vector<MeshIndex> meshes;
};

/// A campus that is ready for walks: the user's description, the models to draw, the world to collide with.
struct Campus {
    CampusDescription description;
    std::vector<Model> models;  ///< one per scene file
    std::vector<CampusObject> objects;
    collision::World world;
    /// The offset subtracted from the scenes' coordinates. Its location on the Earth is the campus file's, or
    /// else that of the first scene that has one.
    Origin origin = {};
    /// What the models and places were read from: scene files, buffers, textures and files of places.
    std::set<std::filesystem::path> files = {};
    /// By model, what it was imported from; empty where that isn't known for all (no cache).
    std::vector<ContentHash> contents = {};
    /// Textures that are missing or can't be decoded: images don't show the campus as it should look.
    std::vector<Diagnostic> texture_warnings = {};
    std::vector<RemovedNode> open_doors = {};

    /// Index of the layer for collision filters; layers the campus doesn't name share index 0.
    std::uint32_t layer_index(const std::string& layer) const {
        const auto found = std::ranges::find(description.layers, layer);
        return found == description.layers.end()
                   ? 0
                   : static_cast<std::uint32_t>(found - description.layers.begin() + 1);
    }
};

/// Imports the scenes and builds every collider's shape and tree. Throws InputError with all errors at once:
/// those of import_model, and
///   no-node          a glob matches no node (with the nearest name)
///   missing-nodes    a collider has neither nodes nor every dimension of its shape
///   empty-mesh       the nodes of a collider have no triangle
///   duplicate-id     two objects have the same id
///   too-many-layers  more than 31
Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings);

/// The same, with models imported by `importer`. With a cache, whatever was imported and built before from
/// the same files is read from it, and the rest is stored in it; the campus and the warnings are the same.
/// `imports_at_once`: from how many threads `importer` may be called at a time; the result doesn't depend on
/// it. `tree`: the trees of the collision meshes; the cache holds only BVH8s, so hybrid trees are built each
/// time.
Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings, const Importer& importer,
                   const CacheFolder* cache = nullptr, std::size_t imports_at_once = 1,
                   collision::TreeKind tree = collision::TreeKind::bvh8);

}  // namespace campuswalk::scene
