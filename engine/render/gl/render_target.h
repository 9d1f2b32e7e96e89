#pragma once

#include <Eigen/Core>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// A framebuffer with sRGB colour and float depth, multisampled or not, and the single-sample one that it is
/// resolved to.
class RenderTarget {
public:
    /// Throws RenderError if the driver doesn't support the size or number of samples.
    RenderTarget(const GlFunctions& gl, int width, int height, int samples);
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;
    ~RenderTarget();

    /// Throws RenderError with the valid range unless the driver supports `scale` times this size.
    static void check_size(const GlFunctions& gl, int width, int height, int scale = 1);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Binds the framebuffer and clears it to `background` (linear) and the far plane.
    void begin(const Eigen::Vector3d& background) const;
    /// Binds the framebuffer again.
    void resume() const;
    /// Binds the depth texture to the active texture unit; multisampled if the target is.
    void bind_depth() const;
    /// Resolves the samples and reads the pixels back.
    Image finish() const;

private:
    GLuint attach_color(int samples) const;
    GLuint attach_depth() const;

    const GlFunctions& gl_;
    int width_ = 0;
    int height_ = 0;
    int samples_ = 0;  // 0 for a single-sample target, as in GL
    GLuint framebuffer_ = 0;
    GLuint color_ = 0;
    GLuint depth_ = 0;
    GLuint resolved_framebuffer_ = 0;
    GLuint resolved_color_ = 0;
};

}  // namespace campuswalk::engine::render
