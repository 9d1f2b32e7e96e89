#include "engine/render/render_target.h"

#include <string>

#include "engine/render/flip_rows.h"
#include "engine/render/render_error.h"

namespace campuswalk::engine::render {
namespace {

void check_complete(const GlFunctions& gl, int width, int height, int samples) {
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw RenderError("the OpenGL driver can't draw a picture of " + std::to_string(width) + "x" +
                          std::to_string(height) + " pixels with " + std::to_string(samples) +
                          " samples each");
    }
}

}  // namespace

void RenderTarget::check_size(const GlFunctions& gl, int width, int height, int scale) {
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    largest /= scale;
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw RenderError("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                          " pixels is out of range: each side must be 1 to " + std::to_string(largest));
    }
}

RenderTarget::RenderTarget(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl), width_(width), height_(height) {
    check_size(gl, width, height);
    gl.GenFramebuffers(1, &framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const int stored = samples > 1 ? samples : 0;
    color_ = attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, stored);
    depth_ = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, stored);
    check_complete(gl, width, height, samples);
    gl.GenFramebuffers(1, &resolved_framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer_);
    resolved_color_ = attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, 0);
    check_complete(gl, width, height, samples);
}

RenderTarget::~RenderTarget() {
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteFramebuffers(1, &resolved_framebuffer_);
    for (const GLuint buffer : {color_, depth_, resolved_color_}) {
        gl_.DeleteRenderbuffers(1, &buffer);
    }
}

GLuint RenderTarget::attach(GLenum attachment, GLenum format, int samples) const {
    GLuint buffer = 0;
    gl_.GenRenderbuffers(1, &buffer);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    return buffer;
}

void RenderTarget::begin(const Eigen::Vector3d& background) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_FRAMEBUFFER_SRGB);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GEQUAL);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearDepth(0.0);
    const Eigen::Vector3f color = background.cast<float>();
    gl_.ClearColor(color.x(), color.y(), color.z(), 1.0F);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Picture RenderTarget::finish() const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_framebuffer_);
    Picture picture;
    picture.width = width_;
    picture.height = height_;
    const std::size_t row = 4 * static_cast<std::size_t>(width_);
    picture.rgba.resize(row * static_cast<std::size_t>(height_));
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    flip_rows(picture.rgba, row);
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
        picture.rgba[i] = 255;
    }
    return picture;
}

}  // namespace campuswalk::engine::render
