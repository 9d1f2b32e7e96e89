#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision/world/world.h"
#include "scene/cache/cache_folder.h"
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
    NodeSelection nodes = {};  ///< whose geometry it stands for
};

/// A campus ready to walk in: what the user described, the models to draw, the world to collide with.
struct Campus {
    CampusDescription description;
    std::vector<Model> models;  ///< one a scene file
    std::vector<CampusObject> objects;
    collision::World world;
    /// What was taken off the scenes' coordinates. On the Earth it is where the campus file says, or else the
    /// first scene that says anything.
    Origin origin = {};

    /// Index of the layer for collision filters; layers the campus doesn't name share index 0.
    std::uint32_t layer_index(const std::string& layer) const {
        const auto found = std::ranges::find(description.layers, layer);
        return found == description.layers.end()
                   ? 0
                   : static_cast<std::uint32_t>(found - description.layers.begin() + 1);
    }
};

/// Imports the scenes and builds every collider's shape and tree. All mistakes are reported together:
/// those of import_model, and
///   no-node        a glob matches no node (with the nearest name)
///   empty-mesh     the nodes of a collider have no triangle
///   duplicate-id   two objects end up with one id
///   too-many-layers more than 31
Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings);

/// The same, its models imported by `importer`. With a cache, what was imported and built before of the same
/// files is taken from there, and what wasn't is kept there: the campus and the warnings are the same.
/// `imports_at_once`: from how many threads `importer` may be called at a time; it makes no difference to
/// what comes out. `tree`: what the collision meshes are given; the cache keeps BVH8s alone, so that hybrid
/// trees are built each time.
Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings, const Importer& importer,
                   const CacheFolder* cache = nullptr, std::size_t imports_at_once = 1,
                   collision::TreeKind tree = collision::TreeKind::bvh8);

}  // namespace campuswalk::scene
