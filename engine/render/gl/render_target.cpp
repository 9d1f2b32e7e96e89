#include "engine/render/gl/render_target.h"

#include <string>

#include "engine/render/gl/render_error.h"
#include "engine/render/image/flip_rows.h"

namespace campuswalk::engine::render {
namespace {

void check_complete(const GlFunctions& gl, int width, int height, int samples) {
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw RenderError("the OpenGL driver can't render a picture of " + std::to_string(width) + "x" +
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
    : gl_(gl), width_(width), height_(height), samples_(samples > 1 ? samples : 0) {
    check_size(gl, width, height);
    gl.GenFramebuffers(1, &framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    color_ = attach_color(samples_);
    depth_ = attach_depth();
    check_complete(gl, width, height, samples);
    if (samples_ == 0) {
        return;
    }
    gl.GenFramebuffers(1, &resolved_framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer_);
    resolved_color_ = attach_color(0);
    check_complete(gl, width, height, samples);
}

RenderTarget::~RenderTarget() {
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteFramebuffers(1, &resolved_framebuffer_);
    for (const GLuint buffer : {color_, resolved_color_}) {
        gl_.DeleteRenderbuffers(1, &buffer);
    }
    gl_.DeleteTextures(1, &depth_);
}

GLuint RenderTarget::attach_color(int samples) const {
    GLuint buffer = 0;
    gl_.GenRenderbuffers(1, &buffer);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_SRGB8_ALPHA8, width_, height_);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
    return buffer;
}

// A texture, as hierarchical Z reads it while the image is drawn.
GLuint RenderTarget::attach_depth() const {
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    const GLenum kind = samples_ > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    gl_.BindTexture(kind, texture);
    if (samples_ > 0) {
        gl_.TexImage2DMultisample(kind, samples_, GL_DEPTH_COMPONENT32F, width_, height_, GL_TRUE);
    } else {
        gl_.TexImage2D(kind, 0, GL_DEPTH_COMPONENT32F, width_, height_, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                       nullptr);
        gl_.TexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, kind, texture, 0);
    return texture;
}

void RenderTarget::begin(const Eigen::Vector3d& background) const {
    resume();
    gl_.Enable(GL_FRAMEBUFFER_SRGB);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GEQUAL);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearDepth(0.0);
    const Eigen::Vector3f color = background.cast<float>();
    gl_.ClearColor(color.x(), color.y(), color.z(), 1.0F);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void RenderTarget::resume() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, width_, height_);
}

void RenderTarget::bind_depth() const {
    gl_.BindTexture(samples_ > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, depth_);
}

Image RenderTarget::finish() const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    if (samples_ > 0) {
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_);
        gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_framebuffer_);
    }
    Image image = Image::filled(width_, height_);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    flip_rows(image.rgba, image.offset(0, 1));
    image.make_opaque();
    return image;
}

}  // namespace campuswalk::engine::render
