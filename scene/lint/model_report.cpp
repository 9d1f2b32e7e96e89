#include "scene/lint/model_report.h"

#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

std::vector<NodeReport> report_nodes(const Model& model) {
    std::vector<NodeReport> reports;
    for (const Node& node : model.nodes) {
        NodeReport report;
        report.name = node.name;
        report.parent = node.parent;
        report.depth = node.parent < 0 ? 0 : reports[static_cast<std::size_t>(node.parent)].depth + 1;
        for (const MeshIndex index : node.meshes) {
            report.triangles += model.meshes[index_of(index)].triangles.size();
        }
        for_each_vertex(model, node, [&](const Eigen::Vector3d& p) { report.bounds.extend(p); });
        reports.push_back(report);
    }
    for (std::size_t i = reports.size(); i-- > 0;) {  // children first
        if (reports[i].parent >= 0) {
            reports[static_cast<std::size_t>(reports[i].parent)].bounds.extend(reports[i].bounds);
        }
    }
    return reports;
}

std::vector<MaterialReport> report_materials(const Model& model) {
    std::vector<MaterialReport> reports;
    for (const Material& material : model.materials) {
        MaterialReport report;
        report.name = material.name;
        if (material.base_color_texture) {
            report.texture = model.textures[index_of(*material.base_color_texture)].name;
        }
        report.alpha_mode = material.alpha_mode;
        report.double_sided = material.double_sided;
        reports.push_back(report);
    }
    for (const Node& node : model.nodes) {
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            reports[index_of(mesh.material)].triangles += mesh.triangles.size();
        }
    }
    return reports;
}

}  // namespace

ModelReport report(const Model& model) {
    ModelReport result;
    result.file = model.file;
    result.geographic = model.geographic;
    result.meshes = model.meshes.size();
    result.nodes = report_nodes(model);
    result.materials = report_materials(model);
    for (const NodeReport& node : result.nodes) {
        result.triangles += node.triangles;
        result.bounds.extend(node.bounds);
    }
    for (const Node& node : model.nodes) {
        result.placements += node.meshes.size();
    }
    for (const Mesh& mesh : model.meshes) {
        result.vertices += mesh.positions.size();
    }
    for (const Texture& texture : model.textures) {
        result.textures.push_back({texture.name, texture.width, texture.height});
    }
    result.warnings = find_lints(model, result);
    return result;
}

}  // namespace campuswalk::scene
