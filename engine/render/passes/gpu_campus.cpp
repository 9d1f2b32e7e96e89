#include "engine/render/passes/gpu_campus.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/render/gl/gpu_texture.h"
#include "engine/render/passes/surface_programs.h"

namespace campuswalk::engine::render {
namespace {

// 0 to 4 are the base colour's, the shadows', the occlusion's and the channels'.
constexpr GLint kGlowUnit = 5;
constexpr GLint kNormalUnit = 6;
constexpr GLint kMetalUnit = 7;

// The driver's threads fill the pixels of what has been handed over, while this one goes on with vertices.
// Less at a time costs more than it brings.
constexpr std::size_t kHandOver = std::size_t{3} * 5000;  // indices

using TextureUse = std::optional<scene::TextureIndex> scene::Material::*;

/// One upload a texture and way of use: whole, as a cut-out, as numbers.
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

    GLuint numbers(const SurfaceMaterial& surface, TextureUse use) {
        const scene::Texture* texture = texture_of(surface, use);
        if (texture == nullptr) {
            return white_;
        }
        GLuint& name = numbers_[texture];
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
    std::map<const scene::Texture*, GLuint> numbers_;
};

void bind_image(const GlFunctions& gl, const ShaderProgram& surface, const char* uniform, GLint unit,
                GLuint texture) {
    gl.ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    gl.BindTexture(GL_TEXTURE_2D, texture);
    surface.set(uniform, unit);
}

void set_culling(const GlFunctions& gl, bool both_sides) {
    (both_sides ? gl.Disable : gl.Enable)(GL_CULL_FACE);
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
        images_.push_back({uploads.colors(surface, &scene::Material::base_color_texture),
                           uploads.colors(surface, &scene::Material::emissive_texture),
                           uploads.numbers(surface, &scene::Material::normal_texture),
                           uploads.numbers(surface, &scene::Material::metallic_roughness_texture)});
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
                !frustum.may_show(batch.bounds)) {
                continue;
            }
            if (cutouts) {
                gl_.BindTexture(GL_TEXTURE_2D, images_[batch.material].color);
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

void GpuCampus::set_material(const ShaderProgram& surface, std::size_t index, bool both_sides) const {
    const scene::Material& material = geometry_.materials[index].material;
    const Images& images = images_[index];
    const SurfaceKind kind = kind_of(material);
    if (kind.glow_map) {
        bind_image(gl_, surface, "glow_map", kGlowUnit, images.glow);
    }
    if (kind.normal_map) {
        bind_image(gl_, surface, "normal_map", kNormalUnit, images.normal);
        surface.set("normal_scale", material.normal_scale);
    }
    if (kind.shiny) {
        bind_image(gl_, surface, "metal_map", kMetalUnit, images.metal);
        surface.set("metal_rough", Eigen::Vector2d(material.metallic, material.roughness));
    }
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, images.color);
    surface.set("base_color", Eigen::Vector4d(material.base_color[0], material.base_color[1],
                                              material.base_color[2], material.base_color[3]));
    surface.set("emissive",
                Eigen::Vector3d(material.emissive[0], material.emissive[1], material.emissive[2]));
    surface.set("alpha_cutoff", material.alpha_cutoff);
    // Translucent all over is glass or water far more often than not; an image with holes is not.
    surface.set("glossy", material.base_color[3] < 1.0F ? 1.0 : 0.0);
    set_culling(gl_, both_sides);
}

void GpuCampus::draw_solid(const ProgramSelector& program_of, scene::AlphaMode mode, const Frustum& frustum,
                           const Eigen::Vector3d& eye, HierarchicalZ* depth) const {
    std::vector<std::pair<double, const Batch*>> order;
    for (const Batch& batch : geometry_.batches) {
        if (geometry_.materials[batch.material].material.alpha_mode == mode &&
            frustum.may_show(batch.bounds)) {
            order.emplace_back(batch.bounds.squaredExteriorDistance(eye), &batch);
        }
    }
    std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });
    mesh_.bind();
    std::size_t waiting = 0;
    for (const auto& [distance, batch] : order) {
        if (depth != nullptr && depth->hides(batch->bounds)) {
            continue;
        }
        const ShaderProgram& surface = program_of(geometry_.materials[batch->material].material);
        surface.use();
        set_material(surface, batch->material, batch->both_sides);
        mesh_.draw(*batch);
        const std::size_t indices = batch->count * batch->instances;
        waiting += indices;
        if (waiting >= kHandOver) {
            gl_.Flush();
            waiting = 0;
        }
        if (depth != nullptr && depth->drawn(indices)) {
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
        for (const std::uint32_t corner : triangle.corners) {
            box.extend(Eigen::Vector3f(geometry_.vertices[corner].position.data()).cast<double>());
        }
        if (frustum.may_show(box)) {
            order.emplace_back(-(triangle.centre - from).squaredNorm(), &triangle);
        }
    }
    if (order.empty()) {
        return;
    }
    std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });
    std::vector<std::uint32_t> indices;
    for (const auto& [distance, triangle] : order) {
        indices.insert(indices.end(), triangle->corners.begin(), triangle->corners.end());
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
