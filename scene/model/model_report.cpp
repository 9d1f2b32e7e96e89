#include "scene/model/model_report.h"

namespace campuswalk::scene {
namespace {

Bounds mesh_bounds(const Mesh& mesh, const Eigen::Matrix4d& X_world_mesh) {
    Bounds bounds;
    const Eigen::Matrix3d linear = X_world_mesh.topLeftCorner<3, 3>();
    const Eigen::Vector3d offset = X_world_mesh.topRightCorner<3, 1>();
    for (const Eigen::Vector3f& position : mesh.positions) {
        bounds.extend(linear * position.cast<double>() + offset);
    }
    return bounds;
}

std::vector<NodeReport> report_nodes(const Model& model) {
    std::vector<NodeReport> reports;
    for (const Node& node : model.nodes) {
        NodeReport report;
        report.name = node.name;
        report.parent = node.parent;
        report.depth = node.parent < 0 ? 0 : reports[static_cast<std::size_t>(node.parent)].depth + 1;
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            const Bounds own = mesh_bounds(mesh, node.X_world_node);
            report.triangles += mesh.triangles.size();
            report.bounds.min = report.bounds.min.cwiseMin(own.min);
            report.bounds.max = report.bounds.max.cwiseMax(own.max);
        }
        reports.push_back(report);
    }
    for (std::size_t i = reports.size(); i-- > 0;) {  // children first: parents come before them
        if (reports[i].parent >= 0) {
            Bounds& parent = reports[static_cast<std::size_t>(reports[i].parent)].bounds;
            parent.min = parent.min.cwiseMin(reports[i].bounds.min);
            parent.max = parent.max.cwiseMax(reports[i].bounds.max);
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
        result.bounds.min = result.bounds.min.cwiseMin(node.bounds.min);
        result.bounds.max = result.bounds.max.cwiseMax(node.bounds.max);
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
