#include "scene/campus.h"

#include <algorithm>
#include <map>

#include "scene/collider_shapes.h"
#include "scene/node_frame.h"
#include "scene/node_selection.h"
#include "scene/object_names.h"

namespace campuswalk::scene {
namespace {

// An object's layer is a bit of a 32-bit mask, and bit 0 is for objects without a layer.
constexpr std::size_t kMostLayers = 31;

collision::Detection to_detection(const DetectionModes& modes) {
    using collision::Detection;
    return (modes.solid ? Detection::solid : Detection::none) |
           (modes.trigger ? Detection::trigger : Detection::none) |
           (modes.ray ? Detection::ray : Detection::none);
}

std::vector<Model> import_scenes(const std::vector<SceneFile>& files, DiagnosticList& diagnostics,
                                 std::vector<Diagnostic>& warnings, const Importer& importer) {
    std::vector<Model> models;
    for (const SceneFile& file : files) {
        try {
            ImportedModel imported = importer(file, EmptyModel::refuse);
            models.push_back(std::move(imported.model));
            warnings.insert(warnings.end(), imported.warnings.begin(), imported.warnings.end());
        } catch (const InputError& error) {
            diagnostics.append(error.diagnostics());
        }
    }
    return models;
}

/// Adds the colliders of a campus to its world, one after the other.
class ColliderBuilder {
public:
    ColliderBuilder(Campus& campus, DiagnosticList& diagnostics, std::vector<Diagnostic>& warnings)
        : campus_(campus), diagnostics_(diagnostics), warnings_(warnings) {}

    void add(const ColliderDescription& collider);

private:
    std::optional<std::size_t> building_index(const ColliderDescription& collider) const;
    /// The collider's globs, or its building's when it needs nodes and names none.
    const std::vector<NodeGlob>& globs_of(const ColliderDescription& collider) const;
    void add_fitted(const ColliderDescription& collider, const std::vector<NodeRef>& nodes,
                    const std::string& id);
    void add_object(const ColliderDescription& collider, const std::string& id, const ShapeSource& source,
                    const std::vector<NodeRef>& nodes);

    Campus& campus_;
    DiagnosticList& diagnostics_;
    std::vector<Diagnostic>& warnings_;
    std::map<std::string, SourceMark> ids_;
};

std::optional<std::size_t> ColliderBuilder::building_index(const ColliderDescription& collider) const {
    const auto& buildings = campus_.description.buildings;
    const auto found = std::ranges::find(buildings, collider.building, &Building::id);
    if (collider.building.empty() || found == buildings.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - buildings.begin());
}

const std::vector<NodeGlob>& ColliderBuilder::globs_of(const ColliderDescription& collider) const {
    const auto building = building_index(collider);
    if (collider.nodes.empty() && building && !is_placed_by_numbers(collider.shape)) {
        return campus_.description.buildings[*building].nodes;
    }
    return collider.nodes;
}

void ColliderBuilder::add(const ColliderDescription& collider) {
    const std::vector<NodeGlob>& globs = globs_of(collider);
    if (globs.empty()) {
        if (is_placed_by_numbers(collider.shape)) {
            add_object(collider, collider.id, ShapeSource{}, {});
        } else {
            diagnostics_.error(collider.mark, "missing-nodes",
                               "collider '" + collider.id +
                                   "' needs nodes to take its shape from, or all numbers of its shape");
        }
        return;
    }
    const std::vector<NodeRef> matches = topmost_matches(campus_.models, globs);
    if (matches.empty()) {
        return;  // check_globs has said so
    }
    if (!collider.each) {
        add_fitted(collider, matches, collider.id);
        return;
    }
    std::vector<std::string> names;
    names.reserve(matches.size());
    for (const NodeRef& match : matches) {
        names.push_back(campus_.models[match.model].nodes[match.node].name);
    }
    const std::vector<std::string> words = distinct_words(names);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        add_fitted(collider, {matches[i]}, collider.id + '/' + words[i]);
    }
}

void ColliderBuilder::add_fitted(const ColliderDescription& collider, const std::vector<NodeRef>& nodes,
                                 const std::string& id) {
    ShapeSource source;
    source.has_nodes = true;
    source.geometry = gather_geometry(campus_.models, nodes);
    if (nodes.size() == 1) {  // several nodes have no frame in common but the world's
        source.frame = upright_frame(campus_.models[nodes[0].model].nodes[nodes[0].node].X_world_node);
    }
    add_object(collider, id, source, nodes);
}

void ColliderBuilder::add_object(const ColliderDescription& collider, const std::string& id,
                                 const ShapeSource& source, const std::vector<NodeRef>& nodes) {
    if (!ids_.emplace(id, collider.mark).second) {
        diagnostics_.error(collider.mark, "duplicate-id",
                           "two objects are called '" + id + "'; rename one of the colliders");
        return;
    }
    std::optional<PlacedShape> placed = place_shape(collider.shape, source);
    if (!placed) {
        diagnostics_.error(collider.mark, "empty-mesh",
                           "the nodes of collider '" + id + "' have no triangle");
        return;
    }
    if (placed->zero_area > 0) {
        warnings_.push_back({Severity::warning, collider.mark, "zero-area",
                             "collider '" + id + "': " + std::to_string(placed->zero_area) +
                                 " triangles without an area are left out"});
    }
    campus_.world.add({std::move(placed->shape), placed->X_world_shape, to_detection(collider.modes),
                       campus_.layer_index(collider.layer)});
    campus_.objects.push_back(
        {id, collider.mark, building_index(collider), collider.popup, collider.popup_rule, nodes});
}

}  // namespace

std::uint32_t Campus::layer_index(const std::string& layer) const {
    const auto found = std::ranges::find(description.layers, layer);
    return found == description.layers.end()
               ? 0
               : static_cast<std::uint32_t>(found - description.layers.begin() + 1);
}

Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings) {
    return load_campus(std::move(description), std::move(broad_phase), warnings, import_scene);
}

Campus load_campus(CampusDescription description, std::unique_ptr<collision::BroadPhase> broad_phase,
                   std::vector<Diagnostic>& warnings, const Importer& importer) {
    DiagnosticList diagnostics;
    if (description.layers.size() > kMostLayers) {
        diagnostics.error(description.mark, "too-many-layers",
                          std::to_string(description.layers.size()) + " layers; at most " +
                              std::to_string(kMostLayers) + " are possible");
    }
    std::vector<Model> models = import_scenes(description.scenes, diagnostics, warnings, importer);
    diagnostics.throw_if_errors();  // without its scenes every glob would be wrong

    Campus campus{std::move(description), std::move(models), {}, collision::World(std::move(broad_phase))};
    for (const Building& building : campus.description.buildings) {
        check_globs(campus.models, building.nodes, diagnostics);
    }
    ColliderBuilder builder(campus, diagnostics, warnings);
    for (const ColliderDescription& collider : campus.description.colliders) {
        check_globs(campus.models, collider.nodes, diagnostics);
        builder.add(collider);
    }
    diagnostics.throw_if_errors();
    return campus;
}

}  // namespace campuswalk::scene
