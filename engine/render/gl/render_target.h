#pragma once

#include <Eigen/Core>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Where an image is drawn: colour (sRGB) and depth (float) with several samples a pixel, and the plain
/// image that they are averaged into.
class RenderTarget {
public:
    /// Throws RenderError when the driver can't do the size or the number of samples.
    RenderTarget(const GlFunctions& gl, int width, int height, int samples);
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;
    ~RenderTarget();

    /// Throws RenderError, naming what is possible, when the driver has no image `scale` times this size.
    static void check_size(const GlFunctions& gl, int width, int height, int scale = 1);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Impl goes here from now on; cleared to `background` (linear) and the far plane.
    void begin(const Eigen::Vector3d& background) const;
    /// Impl goes here again, after it went elsewhere.
    void resume() const;
    /// Binds the depth of what has been drawn to the active texture unit: a 2D texture, multisampled when the
    /// target is.
    void bind_depth() const;
    /// Averages the samples and fetches the pixels.
    Image finish() const;

private:
    GLuint attach_color(int samples) const;
    GLuint attach_depth() const;

    const GlFunctions& gl_;
    int width_ = 0;
    int height_ = 0;
    int samples_ = 0;  // as GL counts them: 0 for one a pixel
    GLuint framebuffer_ = 0;
    GLuint color_ = 0;
    GLuint depth_ = 0;
    GLuint resolved_framebuffer_ = 0;
    GLuint resolved_color_ = 0;
};

}  // namespace campuswalk::engine::render
