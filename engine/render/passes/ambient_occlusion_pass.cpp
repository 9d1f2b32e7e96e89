#include "engine/render/passes/ambient_occlusion_pass.h"

#include <cmath>

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {

AmbientOcclusionPass::AmbientOcclusionPass(const GlFunctions& gl, const ShaderProgram& opaque,
                                           const ShaderProgram& masked)
    : gl_(gl),
      opaque_(opaque),
      masked_(masked),
      occlusion_(gl, "occlusion", {shaders::kVersion, shaders::kScreenChunk, shaders::kScreenVertex},
                 {shaders::kVersion, shaders::kOcclusionFragment}),
      blur_(gl, "occlusion blur", {shaders::kVersion, shaders::kScreenChunk, shaders::kScreenVertex},
            {shaders::kVersion, shaders::kBlurFragment}) {
    gl.GenVertexArrays(1, &no_vertices_);
}

AmbientOcclusionPass::~AmbientOcclusionPass() {
    free_layers();
}

void AmbientOcclusionPass::fit(int width, int height) {
    if (width == image_width_ && height == image_height_) {
        return;
    }
    free_layers();
    image_width_ = width;
    image_height_ = height;
    width_ = (width + 1) / 2;
    height_ = (height + 1) / 2;
    depth_ = make_layer(GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    raw_ = make_layer(GL_RG16F, GL_COLOR_ATTACHMENT0);
    half_smooth_ = make_layer(GL_RG16F, GL_COLOR_ATTACHMENT0);
    // Every pixel of the image is a blend of four of its texels: bytes are read in half the time of floats.
    smooth_ = make_layer(GL_R8, GL_COLOR_ATTACHMENT0);
}

// GL ignores the number 0, which is what layers have before the first fit.
void AmbientOcclusionPass::free_layers() const {
    for (const Layer& layer : {depth_, raw_, half_smooth_, smooth_}) {
        gl_.DeleteFramebuffers(1, &layer.framebuffer);
        gl_.DeleteTextures(1, &layer.texture);
    }
}

AmbientOcclusionPass::Layer AmbientOcclusionPass::make_layer(GLenum format, GLenum attachment) const {
    const bool depth = attachment == GL_DEPTH_ATTACHMENT;
    Layer layer;
    gl_.GenTextures(1, &layer.texture);
    gl_.BindTexture(GL_TEXTURE_2D, layer.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_, height_, 0,
                   depth ? GL_DEPTH_COMPONENT : GL_RG, GL_FLOAT, nullptr);
    const GLint filter = depth ? GL_NEAREST : GL_LINEAR;
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.GenFramebuffers(1, &layer.framebuffer);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, layer.texture, 0);
    if (depth) {
        const GLenum none = GL_NONE;
        gl_.DrawBuffers(1, &none);
        gl_.ReadBuffer(GL_NONE);
    }
    return layer;
}

void AmbientOcclusionPass::fill(const Layer& layer) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
    gl_.BindVertexArray(no_vertices_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void AmbientOcclusionPass::draw(const GpuCampus& campus, const GpuMesh* figure, std::size_t figure_indices,
                                const Viewpoint& view, const Eigen::Matrix4d& clip_campus,
                                double radius) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, depth_.framebuffer);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GEQUAL);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearDepth(0.0);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.Disable(GL_CULL_FACE);
    campus.draw_depth(opaque_, masked_, clip_campus);
    if (figure != nullptr) {
        opaque_.use();
        figure->bind();
        figure->draw(0, figure_indices);
    }

    gl_.Disable(GL_DEPTH_TEST);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, depth_.texture);
    const Eigen::Vector2d size(width_, height_);
    const double tangent = std::tan(0.5 * view.fov);
    const Eigen::Vector2d half(tangent * image_width_ / image_height_, tangent);
    occlusion_.use();
    occlusion_.set("depth_map", 0);
    occlusion_.set("map_size", size);
    occlusion_.set("ray_scale", Eigen::Vector2d(2.0 * half.cwiseQuotient(size)));
    occlusion_.set("ray_offset", Eigen::Vector2d(half.cwiseQuotient(size) - half));
    occlusion_.set("near_distance", view.near_distance);
    occlusion_.set("radius", radius);
    occlusion_.set("pixels_per_radius", radius * height_ / (2.0 * tangent));
    fill(raw_);
    blur(raw_, half_smooth_, Eigen::Vector2i(1, 0));
    blur(half_smooth_, smooth_, Eigen::Vector2i(0, 1));
    gl_.Enable(GL_DEPTH_TEST);
}

void AmbientOcclusionPass::clear_to_unoccluded() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, smooth_.framebuffer);
    gl_.ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void AmbientOcclusionPass::blur(const Layer& from, const Layer& to, const Eigen::Vector2i& axis) const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, from.texture);
    blur_.use();
    blur_.set("occlusion_map", 0);
    blur_.set("axis", axis);
    blur_.set("last", Eigen::Vector2i(width_ - 1, height_ - 1));
    fill(to);
}

void AmbientOcclusionPass::bind(const ShaderProgram& surface) const {
    gl_.ActiveTexture(GL_TEXTURE3);
    gl_.BindTexture(GL_TEXTURE_2D, smooth_.texture);
    surface.set("occlusion_map", 3);
    surface.set("occlusion_scale", Eigen::Vector2d(0.5 / width_, 0.5 / height_));
}

}  // namespace campuswalk::engine::render
