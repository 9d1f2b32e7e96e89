#include "tools/campuswalk/collide/body.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "collision/mesh/mesh_collider.h"
#include "scene/campus/bake_mesh.h"
#include "tools/campuswalk/collide/parse_shape.h"
#include "tools/campuswalk/loading/model_importer.h"

namespace campuswalk::tools::collide {

namespace {

std::vector<scene::NodeRef> roots_of(const scene::Model& model) {
    std::vector<scene::NodeRef> roots;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].parent < 0) {
            roots.push_back({0, n});
        }
    }
    return roots;
}

/// The nodes in the order in which gather_geometry takes their triangles: root by root.
std::vector<Body::Node> nodes_of(const scene::Model& model) {
    std::vector<std::size_t> root_of;
    for (const scene::Node& node : model.nodes) {
        root_of.push_back(node.parent < 0 ? root_of.size() : root_of[static_cast<std::size_t>(node.parent)]);
    }
    std::vector<std::size_t> order(model.nodes.size());
    std::ranges::generate(order, [n = std::size_t{0}]() mutable { return n++; });
    std::ranges::stable_sort(order, {}, [&](std::size_t n) { return root_of[n]; });

    std::vector<Body::Node> nodes;
    std::uint32_t end = 0;
    for (const std::size_t n : order) {
        const std::uint32_t start = end;
        for (const scene::MeshIndex mesh : model.nodes[n].meshes) {
            end += static_cast<std::uint32_t>(model.meshes[index_of(mesh)].triangles.size());
        }
        if (end > start) {
            nodes.push_back({end, model.nodes[n].name});
        }
    }
    return nodes;
}

void check_size(const collision::TriangleMesh& mesh, const scene::SourceMark& mark) {
    const bool fits = std::ranges::all_of(mesh.positions, [](const Eigen::Vector3f& p) {
        return p.cwiseAbs().maxCoeff() <= collision::kMaxCoordinate;
    });
    if (!fits) {
        throw scene::InputError(mark, "bad-size",
                                "it reaches farther than 100 million km; check the file's units and --scale");
    }
}

}  // namespace

const collision::MeshCollider* Body::mesh() const {
    const auto* shared = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&shape);
    return shared != nullptr ? shared->get() : nullptr;
}

const std::string& Body::node_of(std::uint32_t triangle) const {
    const auto node = std::ranges::upper_bound(nodes, triangle, {}, &Node::end);
    assert(node != nodes.end());
    return node->name;
}

Body read_body(const std::string& argument, const scene::SceneFile& frame,
               std::vector<scene::Diagnostic>& warnings) {
    Body body;
    body.name = argument;
    if (const std::optional<collision::Shape> solid = parse_shape(argument)) {
        body.shape = *solid;
        return body;
    }
    scene::SceneFile file = frame;
    file.file = argument;
    file.path = argument;
    file.mark.file = argument;
    scene::ImportedModel imported = read_model(file, scene::EmptyModel::refuse).imported;
    const std::vector<scene::Model> models = {std::move(imported.model)};
    std::ranges::copy_if(imported.warnings, std::back_inserter(warnings),
                         [](const scene::Diagnostic& repair) {
                             return repair.code == "unsupported-feature";  // the others don't move surfaces
                         });
    scene::BakedMesh baked =
        scene::bake_every_triangle(scene::gather_geometry(models, {roots_of(models[0]), {}}));
    check_size(baked.mesh, file.mark);
    body.shape = std::make_shared<const collision::MeshCollider>(
        std::move(baked.mesh), collision::TreeKind::bvh8, collision::Interior::unknown);
    body.p_body_mesh = baked.p_world_origin;
    body.nodes = nodes_of(models[0]);
    return body;
}

}  // namespace campuswalk::tools::collide
