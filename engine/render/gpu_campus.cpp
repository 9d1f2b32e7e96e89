#include "engine/render/gpu_campus.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/render/gpu_texture.h"

namespace campuswalk::engine::render {
namespace {

void set_culling(const GlFunctions& gl, bool double_sided) {
    (double_sided ? gl.Disable : gl.Enable)(GL_CULL_FACE);
}

}  // namespace

GpuCampus::GpuCampus(const GlFunctions& gl, const CampusGeometry& geometry)
    : gl_(gl),
      geometry_(geometry),
      mesh_(gl),
      blend_mesh_(mesh_.sharing_vertices()),
      white_(upload_white(gl)) {
    mesh_.upload_vertices(geometry.vertices);
    mesh_.upload_indices(geometry.indices);
    // One upload a texture, two when it is used both whole and as a cut-out.
    std::map<std::pair<const scene::Texture*, bool>, GLuint> uploaded;
    for (const SurfaceMaterial& surface : geometry.materials) {
        const scene::Texture* texture = surface.texture;
        if (texture == nullptr || texture->rgba.empty()) {
            textures_.push_back(white_);
            continue;
        }
        const bool cutout = surface.material.alpha_mode == scene::AlphaMode::mask;
        GLuint& name = uploaded[{texture, cutout}];
        if (name == 0) {
            name = upload_texture(gl, *texture, cutout, surface.material.alpha_cutoff);
        }
        textures_.push_back(name);
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
                gl_.BindTexture(GL_TEXTURE_2D, textures_[batch.material]);
                program.set("base_color", Eigen::Vector4d(1, 1, 1, material.base_color[3]));
                program.set("alpha_cutoff", material.alpha_cutoff);
            }
            mesh_.draw(batch.first, batch.count);
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

void GpuCampus::set_material(const ShaderProgram& surface, std::size_t index) const {
    const scene::Material& material = geometry_.materials[index].material;
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, textures_[index]);
    surface.set("base_color", Eigen::Vector4d(material.base_color[0], material.base_color[1],
                                              material.base_color[2], material.base_color[3]));
    surface.set("emissive",
                Eigen::Vector3d(material.emissive[0], material.emissive[1], material.emissive[2]));
    surface.set("alpha_cutoff", material.alpha_cutoff);
    // Translucent all over is glass or water far more often than not; a picture with holes is not.
    surface.set("glossy", material.base_color[3] < 1.0F ? 1.0 : 0.0);
    set_culling(gl_, material.double_sided);
}

void GpuCampus::draw_solid(const ShaderProgram& surface, scene::AlphaMode mode, const Frustum& frustum,
                           const Eigen::Vector3d& eye, DrawnDepth* depth) const {
    std::vector<std::pair<double, const Batch*>> order;
    for (const Batch& batch : geometry_.batches) {
        if (geometry_.materials[batch.material].material.alpha_mode == mode &&
            frustum.may_show(batch.bounds)) {
            order.emplace_back(batch.bounds.squaredExteriorDistance(eye), &batch);
        }
    }
    std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });
    mesh_.bind();
    for (const auto& [distance, batch] : order) {
        if (depth != nullptr && depth->hides(batch->bounds)) {
            continue;
        }
        surface.use();
        set_material(surface, batch->material);
        mesh_.draw(batch->first, batch->count);
        if (depth != nullptr && depth->drawn(batch->count)) {
            mesh_.bind();
        }
    }
}

void GpuCampus::draw_blend(const ShaderProgram& surface, const Frustum& frustum,
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
        set_material(surface, order[first].second->material);
        blend_mesh_.draw(3 * first, 3 * (end - first));
        first = end;
    }
}

}  // namespace campuswalk::engine::render
