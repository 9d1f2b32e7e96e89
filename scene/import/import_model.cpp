#include "scene/import/import_model.h"

#include <algorithm>

#include <assimp/scene.h>
#include <Eigen/LU>

#include "scene/import/convert_material.h"
#include "scene/import/convert_mesh.h"
#include "scene/import/convert_nodes.h"
#include "scene/import/file_frame.h"
#include "scene/import/gltf_features.h"
#include "scene/import/read_scene.h"
#include "scene/import/texture_loader.h"

namespace campuswalk::scene {
namespace {

std::string in_quotes(const std::string& name) {
    return "'" + name + "'";
}

/// One import under way: the parts of the model and the complaints about them.
class Import {
public:
    Import(const SceneFile& file, const ReadScene& read, EmptyModel if_empty)
        : file_(file), scene_(*read.scene), if_empty_(if_empty), textures_(scene_, SceneFolder(file.path)) {
        model_.file = file.file;
        tree_ = convert_nodes(*scene_.mRootNode, house_from_file(file, scene_));
    }

    void name_nodes();
    void check_nodes();
    void convert_materials();
    void convert_meshes();
    void mirror_meshes();
    void load_textures();
    void check_side_files(const LockedFiles& files);
    void check_features();
    Model finish(std::vector<Diagnostic>& warnings);

private:
    void convert_one(unsigned int scene_mesh, const std::string& node);
    void report_repairs(const ConvertedMesh& converted, const std::string& node);
    void report_no_triangle(const aiMesh& source, const std::string& node);
    void error(const char* code, const std::string& message) {
        diagnostics_.error(file_.mark, code, message);
    }
    void warning(const char* code, const std::string& message) {
        diagnostics_.warning(file_.mark, code, message);
    }

    const SceneFile& file_;
    const aiScene& scene_;
    EmptyModel if_empty_;
    TextureLoader textures_;
    DiagnosticList diagnostics_;
    NodeTree tree_;
    Model model_;
    std::vector<ConvertedMaterial> materials_;
    std::vector<std::optional<MeshIndex>> mesh_of_;  // by aiScene's mesh; none: not placed or not usable
    std::size_t points_and_lines_ = 0;
    std::string points_and_lines_node_;  // the first that has any
};

/// A COLLADA node may have an id and no name: its id is the author's word all the same.
void Import::name_nodes() {
    const auto is_made_up = [](const Node& node) { return node.name.starts_with(kMadeUpColladaName); };
    if (!std::ranges::any_of(tree_.nodes, is_made_up)) {
        return;
    }
    ReadScene with_ids;
    read_scene(file_, with_ids, ColladaNames::ids);
    const NodeTree ids = convert_nodes(*with_ids.scene->mRootNode, Eigen::Matrix4d::Identity());
    for (std::size_t i = 0; i < tree_.nodes.size() && ids.nodes.size() == tree_.nodes.size(); ++i) {
        if (is_made_up(tree_.nodes[i])) {
            tree_.nodes[i].name = ids.nodes[i].name;
        }
    }
}

void Import::check_nodes() {
    for (const Node& node : tree_.nodes) {
        if (!node.X_world_node.allFinite()) {
            error("bad-vertex",
                  file_.file + ": the transform of node " + in_quotes(node.name) + " is not finite");
        }
    }
}

void Import::convert_materials() {
    for (unsigned int i = 0; i < scene_.mNumMaterials; ++i) {
        materials_.push_back(convert_material(*scene_.mMaterials[i]));
    }
    if (materials_.empty()) {
        materials_.emplace_back();
    }
}

/// Nothing in it can be walked on: a mistake when it was made for triangles, else part of the drawing's
/// lines.
void Import::report_no_triangle(const aiMesh& source, const std::string& node) {
    constexpr unsigned int kPointsAndLines = aiPrimitiveType_POINT | aiPrimitiveType_LINE;
    if ((source.mPrimitiveTypes & ~kPointsAndLines) != 0 || source.mPrimitiveTypes == 0) {
        const std::string message = file_.file + ": the mesh of node " + in_quotes(node) +
                                    " has no triangle; give it faces or remove it";
        if (if_empty_ == EmptyModel::refuse) {
            error("empty-mesh", message);
        } else {
            warning("empty-mesh", message);
        }
    }
}

void Import::report_repairs(const ConvertedMesh& converted, const std::string& node) {
    if (converted.repaired_normals > 0) {
        warning("repaired-normals", file_.file + ": " + std::to_string(converted.repaired_normals) +
                                        " normals of node " + in_quotes(node) +
                                        " have no direction; the faces' are used");
    }
    if (converted.repaired_uvs > 0) {
        warning("repaired-uvs", file_.file + ": " + std::to_string(converted.repaired_uvs) +
                                    " texture coordinates of node " + in_quotes(node) + " are not finite");
    }
}

void Import::convert_one(unsigned int scene_mesh, const std::string& node) {
    const aiMesh& source = *scene_.mMeshes[scene_mesh];
    const std::size_t material = source.mMaterialIndex < materials_.size() ? source.mMaterialIndex : 0;
    MeshStyle style;
    style.flat_normals = is_gltf_name(file_.path);
    style.uv_channel = materials_[material].texture ? materials_[material].texture->uv_channel : 0;
    ConvertedMesh converted = convert_mesh(source, style);
    if (converted.points_and_lines > 0 && points_and_lines_ == 0) {
        points_and_lines_node_ = node;
    }
    points_and_lines_ += converted.points_and_lines;
    if (converted.index_out_of_range) {
        error("bad-model",
              file_.file + ": a face of node " + in_quotes(node) + " uses a vertex that is not there");
    } else if (converted.position_not_finite) {
        error("bad-vertex", file_.file + ": a vertex of node " + in_quotes(node) + " is NaN or infinite");
    } else if (converted.mesh.triangles.empty()) {
        report_no_triangle(source, node);
    } else {
        report_repairs(converted, node);
        converted.mesh.material = static_cast<MaterialIndex>(material);
        mesh_of_[scene_mesh] = static_cast<MeshIndex>(model_.meshes.size());
        model_.meshes.push_back(std::move(converted.mesh));
    }
}

void Import::convert_meshes() {
    mesh_of_.assign(scene_.mNumMeshes, std::nullopt);
    std::vector<bool> seen(scene_.mNumMeshes, false);
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
        for (const unsigned int scene_mesh : tree_.scene_meshes[i]) {
            if (scene_mesh >= scene_.mNumMeshes) {
                continue;
            }
            if (!seen[scene_mesh]) {
                seen[scene_mesh] = true;
                convert_one(scene_mesh, tree_.nodes[i].name);
            }
            if (mesh_of_[scene_mesh]) {
                tree_.nodes[i].meshes.push_back(*mesh_of_[scene_mesh]);
            }
        }
    }
    if (points_and_lines_ > 0) {
        warning("points-and-lines", file_.file + ": " + std::to_string(points_and_lines_) +
                                        " points and lines are left out, the first in node " +
                                        in_quotes(points_and_lines_node_));
    }
}

/// A mirroring transform turns triangles inside out: its nodes get a flipped copy, shared among them.
void Import::mirror_meshes() {
    std::vector<bool> used_upright(model_.meshes.size(), false);
    const auto mirrors = [](const Node& node) {
        return node.X_world_node.topLeftCorner<3, 3>().determinant() < 0.0;
    };
    for (const Node& node : tree_.nodes) {
        for (const MeshIndex mesh : node.meshes) {
            used_upright[index_of(mesh)] = used_upright[index_of(mesh)] || !mirrors(node);
        }
    }
    std::vector<std::optional<MeshIndex>> flipped(model_.meshes.size());
    for (Node& node : tree_.nodes) {
        if (!mirrors(node)) {
            continue;
        }
        for (MeshIndex& mesh : node.meshes) {
            auto& copy = flipped[index_of(mesh)];
            if (!copy) {
                copy = mesh;
                if (used_upright[index_of(mesh)]) {
                    copy = static_cast<MeshIndex>(model_.meshes.size());
                    model_.meshes.push_back(Mesh(model_.meshes[index_of(mesh)]));
                }
                flip_winding(model_.meshes[index_of(*copy)]);
            }
            mesh = *copy;
        }
    }
}

/// Only of materials that something is drawn with: an unused one's missing picture harms nobody.
void Import::load_textures() {
    std::vector<bool> used(materials_.size(), false);
    for (const Mesh& mesh : model_.meshes) {
        used[index_of(mesh.material)] = true;
    }
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        ConvertedMaterial& converted = materials_[i];
        if (used[i] && converted.texture) {
            std::string reason;
            const auto texture = textures_.load(*converted.texture, reason);
            if (!texture) {
                error("bad-texture", file_.file + ": material " + in_quotes(converted.material.name) +
                                         ": texture " + in_quotes(converted.texture->uri) + " " + reason);
                continue;
            }
            converted.material.base_color_texture = texture;
            if (converted.cut_out_by_texture && has_cut_outs(textures_.texture(*texture))) {
                converted.material.alpha_mode = AlphaMode::mask;
            }
        }
    }
}

void Import::check_side_files(const LockedFiles& files) {
    for (const std::string& name : files.refused()) {
        if (name.ends_with(".mtl")) {
            warning("missing-materials", file_.file + ": the material file " + in_quotes(name) +
                                             " is not there; its materials are drawn plain");
            return;
        }
    }
}

void Import::check_features() {
    for (const IgnoredFeature& feature : ignored_gltf_features(file_.path)) {
        warning("unsupported-feature", file_.file + ": " + feature.name + ": " + feature.effect);
    }
}

Model Import::finish(std::vector<Diagnostic>& warnings) {
    if (!diagnostics_.has_errors() && model_.meshes.empty() && if_empty_ == EmptyModel::refuse) {
        error("empty-mesh", in_quotes(file_.file) + " has no triangle");
    }
    diagnostics_.throw_if_errors();
    warnings.insert(warnings.end(), diagnostics_.all().begin(), diagnostics_.all().end());
    model_.nodes = std::move(tree_.nodes);
    model_.textures = textures_.take_textures();
    for (ConvertedMaterial& converted : materials_) {
        model_.materials.push_back(std::move(converted.material));
    }
    return std::move(model_);
}

}  // namespace

Model import_model(const SceneFile& file, std::vector<Diagnostic>& warnings, EmptyModel if_empty) {
    ReadScene read;
    read_scene(file, read);
    Import import(file, read, if_empty);
    import.name_nodes();
    import.check_nodes();
    import.convert_materials();
    import.convert_meshes();
    import.mirror_meshes();
    import.load_textures();
    import.check_side_files(*read.files);
    import.check_features();
    return import.finish(warnings);
}

}  // namespace campuswalk::scene
