#include "engine/render/passes/gpu_campus.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/render/gl/gpu_texture.h"
#include "engine/render/passes/surface_programs.h"

namespace campuswalk::engine::render {
namespace {

// Units 0 to 4: base colour, shadow maps, ambient occlusion, channels.
constexpr GLint kEmissiveUnit = 5;
constexpr GLint kNormalUnit = 6;
constexpr GLint kMetallicRoughnessUnit = 7;

// After a flush the driver's threads rasterize while this thread goes on processing vertices. Smaller batches
// cost more than they gain.
constexpr std::size_t kFlushIndices = std::size_t{3} * 5000;  // indices

using TextureUse = std::optional<scene::TextureIndex> scene::Material::*;

/// Uploads each texture once per use: colour, cut-out or data.
class TextureUploads {
public:
    TextureUploads(const GlFunctions& gl, GLuint white) : gl_(gl), white_(white) {}

    GLuint colors(const SurfaceMaterial& surface, TextureUse use) {
        const scene::Texture* texture = texture_of(surface, use);
        if (texture == nullptr) {
            return white_;
        }
        const scene::Material& material = surface.material;
        const bool cutout =
            use == &scene::Material::base_color_texture && material.alpha_mode == scene::AlphaMode::mask;
        GLuint& name = (cutout ? cutouts_ : colors_)[texture];
        if (name == 0) {
            name = cutout ? upload_cutout_texture(gl_, *texture, material.alpha_cutoff)
                          : upload_color_texture(gl_, *texture);
        }
        return name;
    }

    GLuint data(const SurfaceMaterial& surface, TextureUse use) {
        const scene::Texture* texture = texture_of(surface, use);
        if (texture == nullptr) {
            return white_;
        }
        GLuint& name = data_[texture];
        if (name == 0) {
            name = upload_data_texture(gl_, *texture);
        }
        return name;
    }

private:
    static const scene::Texture* texture_of(const SurfaceMaterial& surface, TextureUse use) {
        const auto& index = surface.material.*use;
        if (!index || surface.model == nullptr || index_of(*index) >= surface.model->textures.size()) {
            return nullptr;
        }
        const scene::Texture& texture = surface.model->textures[index_of(*index)];
        return texture.rgba.empty() ? nullptr : &texture;
    }

    const GlFunctions& gl_;
    GLuint white_;
    std::map<const scene::Texture*, GLuint> colors_;
    std::map<const scene::Texture*, GLuint> cutouts_;
    std::map<const scene::Texture*, GLuint> data_;
};

void bind_texture(const GlFunctions& gl, const ShaderProgram& surface, const char* uniform, GLint unit,
                  GLuint texture) {
    gl.ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    gl.BindTexture(GL_TEXTURE_2D, texture);
    surface.set(uniform, unit);
}

void set_culling(const GlFunctions& gl, bool double_sided) {
    (double_sided ? gl.Disable : gl.Enable)(GL_CULL_FACE);
}

}  // namespace

GpuCampus::GpuCampus(const GlFunctions& gl, const CampusGeometry& geometry)
    : gl_(gl),
      geometry_(geometry),
      mesh_(gl),
      blend_mesh_(mesh_.sharing_vertices()),
      white_(upload_white_texture(gl)) {
    mesh_.upload_vertices(geometry.vertices);
    mesh_.upload_indices(geometry.indices);
    mesh_.upload_instances(geometry.instances);
    TextureUploads uploads(gl, white_);
    for (const SurfaceMaterial& surface : geometry.materials) {
        textures_.push_back({uploads.colors(surface, &scene::Material::base_color_texture),
                             uploads.colors(surface, &scene::Material::emissive_texture),
                             uploads.data(surface, &scene::Material::normal_texture),
                             uploads.data(surface, &scene::Material::metallic_roughness_texture)});
    }
}

void GpuCampus::draw_depth(const ShaderProgram& opaque, const ShaderProgram& masked,
                           const Eigen::Matrix4d& clip_campus) const {
    const Frustum frustum(clip_campus);
    mesh_.bind();
    gl_.ActiveTexture(GL_TEXTURE0);
    for (const bool cutouts : {false, true}) {
        const ShaderProgram& program = cutouts ? masked : opaque;
        program.use();
        program.set("clip_campus", clip_campus);
        program.set("base_color_map", 0);
        for (const Batch& batch : geometry_.batches) {
            const scene::Material& material = geometry_.materials[batch.material].material;
            if ((material.alpha_mode == scene::AlphaMode::mask) != cutouts ||
                !frustum.may_intersect(batch.bounds)) {
                continue;
            }
            if (cutouts) {
                gl_.BindTexture(GL_TEXTURE_2D, textures_[batch.material].color);
                program.set("base_color", Eigen::Vector4d(1, 1, 1, material.base_color[3]));
                program.set("alpha_cutoff", material.alpha_cutoff);
            }
            mesh_.draw(batch);
        }
    }
}

void GpuCampus::set_plain_material(const ShaderProgram& surface) const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, white_);
    surface.set("base_color", Eigen::Vector4d(1, 1, 1, 1));
    surface.set("emissive", Eigen::Vector3d(0, 0, 0));
    set_culling(gl_, false);
}

void GpuCampus::set_material(const ShaderProgram& surface, std::size_t index, bool double_sided) const {
    const scene::Material& material = geometry_.materials[index].material;
    const MaterialTextures& textures = textures_[index];
    const SurfaceKind kind = kind_of(material);
    if (kind.emissive_map) {
        bind_texture(gl_, surface, "emissive_map", kEmissiveUnit, textures.emissive);
    }
    if (kind.normal_map) {
        bind_texture(gl_, surface, "normal_map", kNormalUnit, textures.normal);
        surface.set("normal_scale", material.normal_scale);
    }
    if (kind.specular) {
        bind_texture(gl_, surface, "metallic_roughness_map", kMetallicRoughnessUnit,
                     textures.metallic_roughness);
        surface.set("metallic_roughness", Eigen::Vector2d(material.metallic, material.roughness));
    }
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, textures.color);
    surface.set("base_color", Eigen::Vector4d(material.base_color[0], material.base_color[1],
                                              material.base_color[2], material.base_color[3]));
    surface.set("emissive",
                Eigen::Vector3d(material.emissive[0], material.emissive[1], material.emissive[2]));
    surface.set("alpha_cutoff", material.alpha_cutoff);
    // Uniformly translucent surfaces are mostly glass or water; a texture with holes is not.
    surface.set("reflective", material.base_color[3] < 1.0F ? 1.0 : 0.0);
    set_culling(gl_, double_sided);
}

void GpuCampus::draw_solid(const ProgramSelector& program_of, scene::AlphaMode mode, const Frustum& frustum,
                           const Eigen::Vector3d& eye, HierarchicalZ* depth) const {
    std::vector<std::pair<double, const Batch*>> order;
    for (const Batch& batch : geometry_.batches) {
        if (geometry_.materials[batch.material].material.alpha_mode == mode &&
            frustum.may_intersect(batch.bounds)) {
            order.emplace_back(batch.bounds.squaredExteriorDistance(eye), &batch);
        }
    }
    std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });
    mesh_.bind();
    std::size_t unflushed = 0;
    for (const auto& [distance, batch] : order) {
        if (depth != nullptr && depth->occludes(batch->bounds)) {
            continue;
        }
        const ShaderProgram& surface = program_of(geometry_.materials[batch->material].material);
        surface.use();
        set_material(surface, batch->material, batch->double_sided);
        mesh_.draw(*batch);
        const std::size_t indices = batch->count * batch->instances;
        unflushed += indices;
        if (unflushed >= kFlushIndices) {
            gl_.Flush();
            unflushed = 0;
        }
        if (depth != nullptr && depth->count_drawn(indices)) {
            mesh_.bind();
        }
    }
}

void GpuCampus::draw_blend(const ProgramSelector& program_of, const Frustum& frustum,
                           const Eigen::Vector3d& eye) const {
    std::vector<std::pair<float, const BlendTriangle*>> order;
    const Eigen::Vector3f from = eye.cast<float>();
    for (const BlendTriangle& triangle : geometry_.blend) {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t vertex : triangle.vertices) {
            box.extend(Eigen::Vector3f(geometry_.vertices[vertex].position.data()).cast<double>());
        }
        if (frustum.may_intersect(box)) {
            order.emplace_back(-(triangle.centre - from).squaredNorm(), &triangle);
        }
    }
    if (order.empty()) {
        return;
    }
    std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });
    std::vector<std::uint32_t> indices;
    for (const auto& [distance, triangle] : order) {
        indices.insert(indices.end(), triangle->vertices.begin(), triangle->vertices.end());
    }
    blend_mesh_.upload_indices(indices);
    std::size_t first = 0;
    while (first < order.size()) {
        std::size_t end = first + 1;
        while (end < order.size() && order[end].second->material == order[first].second->material) {
            ++end;
        }
        const std::size_t material = order[first].second->material;
        const ShaderProgram& surface = program_of(geometry_.materials[material].material);
        surface.use();
        set_material(surface, material, geometry_.materials[material].material.double_sided);
        blend_mesh_.draw(3 * first, 3 * (end - first));
        first = end;
    }
}

}  // namespace campuswalk::engine::render
