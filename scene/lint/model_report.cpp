#include "scene/lint/model_report.h"

#include <set>
#include <utility>

#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

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

void report_doors(const Model& model, ModelReport& report) {
    std::vector<ModelLint::Place> closed;
    report.doors = find_doors(model);
    for (const Door& door : report.doors) {
        if (door.is_closed) {
            closed.push_back({model.nodes[door.node].name, door.foot});
        }
    }
    if (!closed.empty()) {
        report.warnings.push_back(solid_doors(std::move(closed)));
    }
}

}  // namespace

std::vector<NodeReport> report_nodes(const Model& model) {
    std::vector<NodeReport> reports;
    for (const Node& node : model.nodes) {
        NodeReport report;
        report.name = node.name;
        report.parent = node.parent;
        report.depth = node.parent < 0 ? 0 : reports[static_cast<std::size_t>(node.parent)].depth + 1;
        std::set<std::size_t> materials;
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            report.triangles += mesh.triangles.size();
            materials.insert(index_of(mesh.material));
        }
        report.materials.assign(materials.begin(), materials.end());
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
    report_doors(model, result);
    result.flights = find_flights(model);
    return result;
}

void add_repairs(const std::vector<Diagnostic>& repairs, ModelReport& report) {
    std::vector<ModelLint> lints;
    lints.reserve(repairs.size());
    for (const Diagnostic& repair : repairs) {
        lints.push_back({repair.code, repair.message});
    }
    report.warnings.insert(report.warnings.begin(), lints.begin(), lints.end());
}

}  // namespace campuswalk::scene
