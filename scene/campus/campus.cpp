#include "scene/campus/campus.h"

#include <atomic>
#include <exception>
#include <iterator>
#include <map>

#include "collision/bvh8/bvh8.h"
#include "scene/cache/load_model.h"
#include "scene/campus/cached_meshes.h"
#include "scene/campus/collider_globs.h"
#include "scene/campus/collider_shapes.h"
#include "scene/campus/object_names.h"
#include "scene/campus/open_doors.h"
#include "scene/campus/place_heights.h"
#include "scene/campus/place_scene.h"
#include "scene/import/source/parallel_for.h"
#include "scene/model/model_limits.h"
#include "scene/model/node_frame.h"

namespace campuswalk::scene {
namespace {

// An object's layer is a bit of a 32-bit mask, and bit 0 is for objects without a layer.
constexpr std::size_t kMaxLayers = 31;

collision::Detection to_detection(const DetectionModes& modes) {
    using collision::Detection;
    return (modes.solid ? Detection::solid : Detection::none) |
           (modes.trigger ? Detection::trigger : Detection::none) |
           (modes.ray ? Detection::ray : Detection::none);
}

/// The models of a campus and the hashes of their contents (see LoadedModel).
struct ImportedScenes {
    std::vector<Model> models;
    std::vector<ContentHash> contents;  ///< fewer than models if some are unknown
    std::set<std::filesystem::path> files;
    std::vector<Diagnostic> texture_warnings;
};

/// Once the models take more than they may, no other is imported.
ImportedScenes import_scenes(const CampusDescription& campus, DiagnosticList& diagnostics,
                             std::vector<Diagnostic>& warnings, const Importer& importer,
                             const CacheFolder* cache, std::size_t imports_at_once) {
    const std::vector<SceneFile>& files = campus.scenes;
    std::atomic<std::uint64_t> bytes = 0;
    std::vector<LoadedModel> models(files.size());
    std::vector<std::exception_ptr> failures(files.size());
    parallel_for(files.size(), imports_at_once, [&](std::size_t i) {
        if (bytes > kMaxModelBytes) {
            return;
        }
        try {
            models[i] = load_model(files[i], EmptyModel::refuse, importer, cache);
            place_scene(files[i], models[i].imported.model);
            bytes += count_bytes(models[i].imported.model);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    if (bytes > kMaxModelBytes) {
        throw InputError(campus.mark, "too-large-models",
                         "the campus's models take more than " + std::to_string(kMaxModelBytes >> 30U) +
                             " GB of memory together; use smaller textures, or fewer or simpler models");
    }
    ImportedScenes scenes;
    for (std::size_t i = 0; i < files.size(); ++i) {
        try {
            if (failures[i]) {
                std::rethrow_exception(failures[i]);
            }
            LoadedModel& loaded = models[i];
            scenes.models.push_back(std::move(loaded.imported.model));
            scenes.files.insert(loaded.files.begin(), loaded.files.end());
            if (loaded.contents) {
                scenes.contents.push_back(placed_contents(files[i], *loaded.contents));
            }
            std::ranges::copy_if(loaded.imported.warnings, std::back_inserter(scenes.texture_warnings),
                                 [](const Diagnostic& warning) { return warning.code == "bad-texture"; });
            warnings.insert(warnings.end(), loaded.imported.warnings.begin(), loaded.imported.warnings.end());
        } catch (const InputError& error) {
            diagnostics.append(error.diagnostics());
        }
    }
    return scenes;
}

Origin move_to_origin(const CampusOrigin& requested, std::vector<Model>& models) {
    Origin origin = requested.origin;
    if (requested.near) {
        origin.at = origin_near(world_bounds(models.front()));
    }
    for (Model& model : models) {
        if (!origin.at.isZero(0.0)) {
            move_origin(model, origin.at);
        }
        if (!origin.geographic) {
            origin.geographic = model.geographic;
        }
    }
    return origin;
}

std::string reason(NoInside why) {
    switch (why) {
        case NoInside::flat:
            return "its surface is flat";
        case NoInside::open:
            return "its surface is open, and the rim of an opening isn't flat";
        case NoInside::too_large:
            return "its surface isn't closed, and has too many faces (over " +
                   std::to_string(kMostClosedFaces) + ") to close it";
        case NoInside::branching:
            break;
    }
    return "three or more faces meet at an edge of its surface, as where a wall divides its inside: take "
           "such "
           "faces out";
}

/// Adds the colliders of a campus to its world, one after the other.
class ColliderBuilder {
public:
    ColliderBuilder(Campus& campus, NodeSelector& selector, CachedMeshes& meshes, collision::TreeKind tree,
                    DiagnosticList& diagnostics, std::vector<Diagnostic>& warnings)
        : campus_(campus),
          selector_(selector),
          meshes_(meshes),
          tree_(tree),
          diagnostics_(diagnostics),
          warnings_(warnings) {}

    void add(const ColliderDescription& collider);

private:
    std::optional<PlacedShape> shape_of(const ColliderDescription& collider, const std::string& id,
                                        const NodeSelection& selection);
    void add_object(const ColliderDescription& collider, const std::string& id,
                    const NodeSelection& selection);

    Campus& campus_;
    NodeSelector& selector_;
    CachedMeshes& meshes_;
    collision::TreeKind tree_;
    DiagnosticList& diagnostics_;
    std::vector<Diagnostic>& warnings_;
    std::map<std::string, SourceMark> ids_;
    std::size_t triangles_ = 0;  ///< of all objects so far
};

void ColliderBuilder::add(const ColliderDescription& collider) {
    const std::vector<NodeGlob>& globs = globs_of(campus_.description, collider);
    if (globs.empty()) {
        if (!collider.except.empty()) {
            diagnostics_.error(collider.except.front().mark, "missing-nodes",
                               "'except' filters 'nodes', but collider '" + collider.id + "' has no 'nodes'");
        } else if (is_placed_by_numbers(collider.shape)) {
            add_object(collider, collider.id, {});
        } else {
            diagnostics_.error(
                collider.mark, "missing-nodes",
                "collider '" + collider.id +
                    "' needs either 'nodes' to take its shape from or every dimension of its shape");
        }
        return;
    }
    const NodeSelection selection = selector_.select(globs, collider.except);
    const std::vector<NodeRef>& matches = selection.roots;
    if (matches.empty()) {
        if (!topmost_matches(campus_.models, globs).empty()) {  // otherwise check() has reported it
            diagnostics_.error(collider.except.front().mark, "empty-mesh",
                               "'except' excludes every node of collider '" + collider.id + "'");
        }
        return;
    }
    if (!collider.each) {
        add_object(collider, collider.id, selection);
        return;
    }
    std::vector<std::string> names;
    names.reserve(matches.size());
    for (const NodeRef& match : matches) {
        names.push_back(campus_.models[match.model].nodes[match.node].name);
    }
    const std::vector<std::string> words = distinct_words(names);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        add_object(collider, collider.id + '/' + words[i], {{matches[i]}, selection.except});
    }
}

void check_size(const WorldGeometry& geometry, const ColliderDescription& collider, const std::string& id) {
    const bool fits = std::ranges::all_of(geometry.positions, [](const Eigen::Vector3d& position) {
        return position.cwiseAbs().maxCoeff() <= static_cast<double>(collision::kMaxCoordinate);
    });
    if (!fits) {
        throw InputError(
            collider.mark, "bad-size",
            "the nodes of collider '" + id +
                "' reach farther than 100 million km; check the 'unit' and 'scale' of the scene");
    }
}

std::optional<PlacedShape> ColliderBuilder::shape_of(const ColliderDescription& collider,
                                                     const std::string& id, const NodeSelection& selection) {
    const std::vector<NodeRef>& nodes = selection.roots;
    const bool is_mesh = std::holds_alternative<MeshShape>(collider.shape);
    if (is_mesh) {
        if (std::optional<PlacedShape> cached = meshes_.find(id)) {
            return cached;
        }
    }
    ShapeSource source;
    source.has_nodes = !nodes.empty();
    source.tree = tree_;
    source.geometry = gather_geometry(campus_.models, selection);
    if (nodes.size() == 1) {  // the only common frame of several nodes is the world's
        source.frame = upright_frame(campus_.models[nodes[0].model].nodes[nodes[0].node].X_world_node);
    }
    check_size(source.geometry, collider, id);
    triangles_ += source.geometry.triangles.size();
    if (triangles_ > kMaxTriangles) {
        throw InputError(collider.mark, "too-many-triangles",
                         "the colliders have more than " + std::to_string(kMaxTriangles) +
                             " triangles together, those of collider '" + id +
                             "' included; use boxes for some, or a simpler model");
    }
    std::optional<PlacedShape> placed = place_shape(collider.shape, source);
    if (is_mesh && placed) {
        if (is_only_trigger(collider.modes)) {
            placed = enclosed(std::move(*placed), source);
        }
        meshes_.add(id, *placed);
    }
    return placed;
}

void ColliderBuilder::add_object(const ColliderDescription& collider, const std::string& id,
                                 const NodeSelection& selection) {
    if (!ids_.emplace(id, collider.mark).second) {
        diagnostics_.error(collider.mark, "duplicate-id",
                           "two objects have the id '" + id + "'; rename one of the colliders");
        return;
    }
    std::optional<PlacedShape> placed = shape_of(collider, id, selection);
    if (!placed) {
        diagnostics_.error(collider.mark, "empty-mesh",
                           "the nodes of collider '" + id + "' have no triangles");
        return;
    }
    if (placed->no_inside) {
        diagnostics_.error(collider.mark, "no-inside",
                           "nobody can be inside of trigger '" + id + "': " + reason(*placed->no_inside) +
                               (placed->no_inside == NoInside::branching ? "" : "; close it") +
                               ", or give the trigger a 'box' or another shape");
        return;
    }
    if (placed->openings > 0) {
        warnings_.push_back(
            {Severity::warning, collider.mark, "closed-openings",
             "trigger '" + id +
                 "': openings of its surface that are taken for closed, so that visitors can be inside: " +
                 std::to_string(placed->openings)});
    }
    if (placed->left_out > 0) {
        warnings_.push_back({Severity::warning, collider.mark, "open-parts",
                             "trigger '" + id + "': faces that are left out because they enclose nothing: " +
                                 std::to_string(placed->left_out)});
    }
    if (placed->zero_area > 0) {
        warnings_.push_back({Severity::warning, collider.mark, "zero-area",
                             "collider '" + id + "': " + std::to_string(placed->zero_area) +
                                 " zero-area triangles are ignored"});
    }
    campus_.world.add({std::move(placed->shape), placed->X_world_shape, to_detection(collider.modes),
                       campus_.layer_index(collider.layer)});
    campus_.objects.push_back({id, collider.mark, building_of(campus_.description, collider), collider.popup,
                               collider.popup_rule, selection});
}

}  // namespace

Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings) {
    return load_campus(std::move(description), std::move(broad_phase), warnings, import_model);
}

Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings, const Importer& importer, const CacheFolder* cache,
                   std::size_t imports_at_once, collision::TreeKind tree) {
    DiagnosticList diagnostics;
    if (description.layers.size() > kMaxLayers) {
        diagnostics.error(description.mark, "too-many-layers",
                          std::to_string(description.layers.size()) + " layers declared; the maximum is " +
                              std::to_string(kMaxLayers));
    }
    if (description.scenes.size() > kMaxScenes) {
        throw InputError(description.mark, "too-many-scenes",
                         std::to_string(description.scenes.size()) + " scenes; a campus may have " +
                             std::to_string(kMaxScenes));
    }
    ImportedScenes scenes =
        import_scenes(description, diagnostics, warnings, importer, cache, imports_at_once);
    diagnostics.throw_if_errors();  // without the scenes no glob would match

    Campus campus{
        std::move(description), std::move(scenes.models), {}, collision::World(std::move(broad_phase))};
    campus.files = std::move(scenes.files);
    campus.files.insert(campus.description.place_files.begin(), campus.description.place_files.end());
    warnings.insert(warnings.end(), campus.description.warnings.begin(), campus.description.warnings.end());
    campus.texture_warnings = std::move(scenes.texture_warnings);
    campus.origin = move_to_origin(campus.description.origin, campus.models);
    NodeSelector selector(campus.models);
    for (const Building& building : campus.description.buildings) {
        selector.check(building.nodes, diagnostics);
    }
    const bool cacheable = cache != nullptr && tree == collision::TreeKind::bvh8 &&
                           scenes.contents.size() == campus.models.size();
    CachedMeshes meshes = cacheable
                              ? CachedMeshes(*cache, campus.description, campus.origin.at, scenes.contents)
                              : CachedMeshes();
    if (scenes.contents.size() == campus.models.size()) {
        campus.contents = scenes.contents;
    }
    ColliderBuilder builder(campus, selector, meshes, tree, diagnostics, warnings);
    for (const ColliderDescription& collider : campus.description.colliders) {
        selector.check(collider.nodes, diagnostics);
        selector.check(collider.except, diagnostics);
        builder.add(collider);
    }
    diagnostics.throw_if_errors();
    put_places_on_ground(campus.world, campus.description.places, warnings);
    meshes.keep();
    remove_open_doors(campus);
    return campus;
}

}  // namespace campuswalk::scene
