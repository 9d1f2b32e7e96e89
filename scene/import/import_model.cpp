#include "scene/import/import_model.h"

#include <algorithm>
#include <map>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "scene/base/glob.h"
#include "scene/base/unicode_words.h"
#include "scene/base/utf8.h"
#include "scene/import/assimp/assimp_source.h"
#include "scene/import/gltf/gltf_source.h"
#include "scene/import/model_formats.h"
#include "scene/import/source/mirror_meshes.h"
#include "scene/import/source/model_source.h"
#include "scene/model/model_limits.h"

namespace campuswalk::scene {
namespace {

/// Decodes the textures that materials refer to, each once.
class TextureLoader {
public:
    explicit TextureLoader(ModelSource& source) : source_(source) {}

    /// nullopt if the image is missing or cannot be decoded; `reason` then says which, the first time.
    std::optional<TextureIndex> load(const TextureReference& reference, std::string& reason) {
        const std::pair key(reference.uri, reference.wrap);
        const auto [known, is_new] = loaded_.try_emplace(key);
        if (!is_new) {
            return known->second;
        }
        auto image = source_.load_image(reference, reason);
        if (!image) {
            return std::nullopt;
        }
        const auto index = static_cast<TextureIndex>(textures_.size());
        textures_.push_back(
            {reference.uri, image->width, image->height, std::move(image->rgba), reference.wrap});
        known->second = index;
        return index;
    }

    const Texture& texture(TextureIndex index) const { return textures_[index_of(index)]; }
    std::vector<Texture> take_textures() { return std::move(textures_); }

private:
    ModelSource& source_;
    std::vector<Texture> textures_;
    std::map<std::pair<std::string, TextureWrap>, std::optional<TextureIndex>> loaded_;  // by uri
};

/// Whether the image has transparent and opaque pixels.
bool has_cut_outs(const Texture& texture) {
    constexpr std::uint8_t kMaxTransparent = 63;
    bool transparent = false;
    bool opaque = false;
    for (std::size_t i = 3; i < texture.rgba.size(); i += 4) {
        transparent = transparent || texture.rgba[i] <= kMaxTransparent;
        opaque = opaque || texture.rgba[i] == 255;
    }
    return transparent && opaque;
}

/// Makes a Model from a source: validates nodes, sanitizes meshes, loads textures.
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
    void check_triangles();
    void check_reach();
    void load_textures();
    ImportedModel finish();

private:
    std::optional<MeshIndex> convert_one(std::size_t number, const std::string& node);
    void load_texture(const SourceImage& image, SourceMaterial& source);
    void report_bad_texture(const std::string& message);
    void report_repairs(const SanitizedMesh& sanitized, const std::string& node);
    void error(DiagnosticCode code, const std::string& message) {
        diagnostics_.error(file_.mark, code, file_.file + ": " + message);
    }
    void warning(DiagnosticCode code, const std::string& message) {
        diagnostics_.warning(file_.mark, code, file_.file + ": " + message);
    }

    const SceneFile& file_;
    ModelSource& source_;
    EmptyModel if_empty_;
    TextureLoader textures_;
    DiagnosticList diagnostics_;
    NodeTree tree_;
    std::vector<SourceMaterial> materials_;
    Model model_;
    std::map<std::size_t, std::optional<MeshIndex>> mesh_of_;  // by number in the source; nullopt: unusable
    std::size_t points_and_lines_ = 0;
    std::string points_and_lines_node_;  // the first node that has any
    std::size_t bad_textures_ = 0;
};

/// Names are compared in normalization form C, as ids and globs are.
void Import::check_nodes() {
    std::size_t unreadable = 0;
    std::string first;
    for (Node& node : tree_.nodes) {
        node.name = normalized(node.name);
        if (!is_utf8(node.name) && unreadable++ == 0) {
            first = glob_for(node.name);
        }
    }
    if (unreadable > 0) {
        warning("bad-encoding", "the names of " + std::to_string(unreadable) +
                                    " nodes aren't UTF-8 (the first: '" + first +
                                    "'); save the file as UTF-8, or write ? in globs for each such byte");
    }
    for (const Node& node : tree_.nodes) {
        if (!node.X_world_node.allFinite()) {
            error("bad-vertex", "the transform of node '" + node.name + "' is not finite");
        }
    }
}

void Import::report_repairs(const SanitizedMesh& sanitized, const std::string& node) {
    if (sanitized.repaired_normals > 0) {
        warning("repaired-normals", std::to_string(sanitized.repaired_normals) + " normals of node '" + node +
                                        "' have zero length; face normals are used instead");
    }
    if (sanitized.repaired_uvs > 0) {
        warning("repaired-uvs", std::to_string(sanitized.repaired_uvs) + " texture coordinates of node '" +
                                    node + "' are not finite");
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
        error("bad-model", "a face of node '" + node + "' refers to a vertex that does not exist");
    } else if (sanitized.position_not_finite) {
        error("bad-vertex", "a vertex of node '" + node + "' is NaN or infinite");
    } else if (sanitized.mesh.triangles.empty()) {
        if (!has_points_and_lines) {  // those are reported by their own code
            const std::string message =
                "the mesh of node '" + node + "' has no triangles; add faces or remove it";
            if (if_empty_ == EmptyModel::refuse) {
                error("empty-mesh", message);
            } else {
                warning("empty-mesh", message);
            }
        }
    } else {
        report_repairs(sanitized, node);
        sanitized.mesh.material = static_cast<MaterialIndex>(material);
        model_.meshes.push_back(std::move(sanitized.mesh));
        return static_cast<MeshIndex>(model_.meshes.size() - 1);
    }
    return std::nullopt;
}

void Import::check_triangles() {
    std::size_t placed = 0;
    for (const Node& node : tree_.nodes) {
        for (const MeshIndex mesh : node.meshes) {
            placed += model_.meshes[index_of(mesh)].triangles.size();
        }
    }
    if (placed > kMaxTriangles) {
        error("bad-model", "its nodes place " + std::to_string(placed) + " triangles; a model may have " +
                               std::to_string(kMaxTriangles) + ": simplify or split it");
    }
}

/// Far beyond the numbers that trees and pictures are made with.
void Import::check_reach() {
    model_.nodes = std::move(tree_.nodes);
    if (const auto node = find_node_beyond(model_, kMaxReach)) {
        error("bad-size", "node '" + model_.nodes[*node].name +
                              "' reaches farther than 100 million km; check the file's unit and scale");
    }
    tree_.nodes = std::move(model_.nodes);
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
    check_triangles();
    check_reach();
    if (points_and_lines_ > 0) {
        warning("points-and-lines", std::to_string(points_and_lines_) +
                                        " points and lines are ignored, the first in node '" +
                                        points_and_lines_node_ + "'");
    }
}

/// Only those of materials in use: a missing image of another material does no harm.
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

/// What a surface looks like whose base colour, or glow, only its texture knew.
void make_plain(Material& material, std::optional<TextureIndex> Material::*use) {
    if (use == &Material::emissive_texture) {
        material.emissive = {0, 0, 0};
    } else if (use == &Material::base_color_texture) {
        constexpr float kGrey = 0.5F;
        constexpr float kWhite = 0.99F;
        auto& color = material.base_color;
        if (std::min({color[0], color[1], color[2]}) >= kWhite) {
            color = {kGrey, kGrey, kGrey, color[3]};
        }
        material.alpha_mode = AlphaMode::opaque;
    }
}

/// The first few; the models of some archives come without any of their hundreds of textures.
void Import::report_bad_texture(const std::string& message) {
    constexpr std::size_t kReported = 5;
    if (++bad_textures_ <= kReported) {
        warning("bad-texture", message + "; the surface is plain");
    } else if (bad_textures_ == kReported + 1) {
        warning("bad-texture", "more textures are missing or can't be decoded");
    }
}

void Import::load_texture(const SourceImage& image, SourceMaterial& source) {
    Material& material = source.material;
    std::string reason;
    const auto texture = textures_.load(image.reference, reason);
    if (!texture) {
        if (!reason.empty()) {
            report_bad_texture("material '" + material.name + "': texture '" + image.reference.uri + "' " +
                               reason);
        }
        make_plain(material, image.use);
        return;
    }
    material.*image.use = texture;
    if (image.use == &Material::base_color_texture && source.cut_out_by_texture &&
        has_cut_outs(textures_.texture(*texture))) {
        material.alpha_mode = AlphaMode::mask;
    }
}

ImportedModel Import::finish() {
    if (!diagnostics_.has_errors() && model_.meshes.empty() && if_empty_ == EmptyModel::refuse) {
        diagnostics_.error(file_.mark, "empty-mesh", "'" + file_.file + "' has no triangles");
    }
    diagnostics_.throw_if_errors();
    source_.add_warnings(diagnostics_);
    model_.nodes = std::move(tree_.nodes);
    model_.geographic = source_.geographic();
    mirror_meshes(model_);
    model_.textures = textures_.take_textures();
    for (SourceMaterial& material : materials_) {
        model_.materials.push_back(std::move(material.material));
    }
    return {std::move(model_), diagnostics_.all(), source_.requests()};
}

std::unique_ptr<ModelSource> open_source(const SceneFile& file) {
    check_readable(file);
    switch (reader_for(file)) {
        case Reader::gltf:
            return std::make_unique<gltf::GltfSource>(file);
        case Reader::assimp:
            break;
    }
    return std::make_unique<AssimpSource>(file);
}

}  // namespace

ImportedModel import_model(const SceneFile& file, EmptyModel if_empty) {
    try {
        const std::unique_ptr<ModelSource> source = open_source(file);
        Import import(*source, file, if_empty);
        import.check_nodes();
        import.convert_meshes();
        import.load_textures();
        return import.finish();
    } catch (const std::bad_alloc&) {
        throw InputError(file.mark, "bad-model",
                         "'" + file.file + "' needs more memory than is available; simplify or split it");
    } catch (const std::length_error&) {
        throw InputError(file.mark, "bad-model",
                         "'" + file.file + "' asks for an impossible allocation size");
    }
}

}  // namespace campuswalk::scene
