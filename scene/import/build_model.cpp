#include "scene/import/build_model.h"

#include <map>

#include "scene/import/source/mirror_meshes.h"
#include "scene/import/source/texture_loader.h"

namespace campuswalk::scene {
namespace {

std::string in_quotes(const std::string& name) {
    return "'" + name + "'";
}

/// One import under way: the parts of the model and the diagnostics about them.
class Import {
public:
    Import(ModelSource& source, const SceneFile& file, EmptyModel if_empty)
        : file_(file),
          source_(source),
          if_empty_(if_empty),
          textures_(source),
          tree_(source.nodes()),
          materials_(source.materials()) {
        model_.file = file.file;
    }

    void check_nodes();
    void convert_meshes();
    void load_textures();
    Model finish(std::vector<Diagnostic>& warnings);

private:
    std::optional<MeshIndex> convert_one(std::size_t number, const std::string& node);
    void load_texture(const SourceImage& image, SourceMaterial& source);
    void report_repairs(const SanitizedMesh& sanitized, const std::string& node);
    void report_no_triangle(const std::string& node);
    void error(const char* code, const std::string& message) {
        diagnostics_.error(file_.mark, code, message);
    }
    void warning(const char* code, const std::string& message) {
        diagnostics_.warning(file_.mark, code, message);
    }

    const SceneFile& file_;
    ModelSource& source_;
    EmptyModel if_empty_;
    TextureLoader textures_;
    DiagnosticList diagnostics_;
    NodeTree tree_;
    std::vector<SourceMaterial> materials_;
    Model model_;
    std::map<std::size_t, std::optional<MeshIndex>> mesh_of_;  // by the reader's number; none: not usable
    std::size_t points_and_lines_ = 0;
    std::string points_and_lines_node_;  // the first that has any
};

void Import::check_nodes() {
    for (const Node& node : tree_.nodes) {
        if (!node.X_world_node.allFinite()) {
            error("bad-vertex",
                  file_.file + ": the transform of node " + in_quotes(node.name) + " is not finite");
        }
    }
}

/// Nothing in it can be walked on.
void Import::report_no_triangle(const std::string& node) {
    const std::string message =
        file_.file + ": the mesh of node " + in_quotes(node) + " has no triangles; add faces or remove it";
    if (if_empty_ == EmptyModel::refuse) {
        error("empty-mesh", message);
    } else {
        warning("empty-mesh", message);
    }
}

void Import::report_repairs(const SanitizedMesh& sanitized, const std::string& node) {
    if (sanitized.repaired_normals > 0) {
        warning("repaired-normals", file_.file + ": " + std::to_string(sanitized.repaired_normals) +
                                        " normals of node " + in_quotes(node) +
                                        " have zero length; face normals are used instead");
    }
    if (sanitized.repaired_uvs > 0) {
        warning("repaired-uvs", file_.file + ": " + std::to_string(sanitized.repaired_uvs) +
                                    " texture coordinates of node " + in_quotes(node) + " are not finite");
    }
}

std::optional<MeshIndex> Import::convert_one(std::size_t number, const std::string& node) {
    RawMesh raw = source_.mesh(number);
    if (raw.points_and_lines > 0 && points_and_lines_ == 0) {
        points_and_lines_node_ = node;
    }
    points_and_lines_ += raw.points_and_lines;
    const std::size_t material = raw.material < materials_.size() ? raw.material : 0;
    const bool has_points_and_lines = raw.points_and_lines > 0;
    SanitizedMesh sanitized = sanitize_mesh(std::move(raw), source_.flat_normals());
    if (sanitized.index_out_of_range) {
        error("bad-model",
              file_.file + ": a face of node " + in_quotes(node) + " refers to a vertex that does not exist");
    } else if (sanitized.position_not_finite) {
        error("bad-vertex", file_.file + ": a vertex of node " + in_quotes(node) + " is NaN or infinite");
    } else if (sanitized.mesh.triangles.empty()) {
        if (!has_points_and_lines) {  // else part of the drawing's lines
            report_no_triangle(node);
        }
    } else {
        report_repairs(sanitized, node);
        sanitized.mesh.material = static_cast<MaterialIndex>(material);
        model_.meshes.push_back(std::move(sanitized.mesh));
        return static_cast<MeshIndex>(model_.meshes.size() - 1);
    }
    return std::nullopt;
}

void Import::convert_meshes() {
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
        Node& node = tree_.nodes[i];
        for (const std::size_t number : tree_.mesh_numbers[i]) {
            auto known = mesh_of_.find(number);
            if (known == mesh_of_.end()) {
                known = mesh_of_.emplace(number, convert_one(number, node.name)).first;
            }
            if (known->second) {
                node.meshes.push_back(*known->second);
            }
        }
    }
    if (points_and_lines_ > 0) {
        warning("points-and-lines", file_.file + ": " + std::to_string(points_and_lines_) +
                                        " points and lines are ignored, the first in node " +
                                        in_quotes(points_and_lines_node_));
    }
}

/// Only of materials that something is drawn with: an unused one's missing image harms nobody.
void Import::load_textures() {
    std::vector<bool> used(materials_.size(), false);
    for (const Mesh& mesh : model_.meshes) {
        used[index_of(mesh.material)] = true;
    }
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        SourceMaterial& material = materials_[i];
        if (used[i]) {
            for (const SourceImage& image : material.images) {
                load_texture(image, material);
            }
        }
    }
}

/// Without its colours a surface can't be shown; without its bumps or its glow it can.
void Import::load_texture(const SourceImage& image, SourceMaterial& source) {
    Material& material = source.material;
    std::string reason;
    const auto texture = textures_.load(image.reference, reason);
    if (!texture) {
        const std::string message = file_.file + ": material " + in_quotes(material.name) + ": texture " +
                                    in_quotes(image.reference.uri) + " " + reason;
        if (image.use == &Material::base_color_texture) {
            error("bad-texture", message);
            return;
        }
        warning("bad-texture", message + "; drawn without the texture");
        if (image.use == &Material::emissive_texture) {
            material.emissive = {0, 0, 0};  // it says where the surface glows: not all over
        }
        return;
    }
    material.*image.use = texture;
    if (image.use == &Material::base_color_texture && source.cut_out_by_texture &&
        has_cut_outs(textures_.texture(*texture))) {
        material.alpha_mode = AlphaMode::mask;
    }
}

Model Import::finish(std::vector<Diagnostic>& warnings) {
    if (!diagnostics_.has_errors() && model_.meshes.empty() && if_empty_ == EmptyModel::refuse) {
        error("empty-mesh", in_quotes(file_.file) + " has no triangles");
    }
    diagnostics_.throw_if_errors();
    source_.add_warnings(diagnostics_);
    warnings.insert(warnings.end(), diagnostics_.all().begin(), diagnostics_.all().end());
    model_.nodes = std::move(tree_.nodes);
    model_.geographic = source_.geographic();
    mirror_meshes(model_);
    model_.textures = textures_.take_textures();
    for (SourceMaterial& material : materials_) {
        model_.materials.push_back(std::move(material.material));
    }
    return std::move(model_);
}

}  // namespace

Model build_model(ModelSource& source, const SceneFile& file, std::vector<Diagnostic>& warnings,
                  EmptyModel if_empty) {
    Import import(source, file, if_empty);
    import.check_nodes();
    import.convert_meshes();
    import.load_textures();
    return import.finish(warnings);
}

}  // namespace campuswalk::scene
