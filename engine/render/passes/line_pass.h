#pragma once

#include <span>

#include <Eigen/Core>

#include "engine/render/geometry/overlay_lines.h"
#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"

namespace campuswalk::engine::render {

/// Draws lines over a finished image: in full where visible, faintly where occluded. Must not outlive its
/// context.
class LinePass {
public:
    explicit LinePass(const GlFunctions& gl);

    /// `origin` (world frame) is the campus frame's; the render target must be bound.
    void draw(std::span<const OverlayLine> lines, const Eigen::Matrix4d& clip_campus,
              const Eigen::Vector3d& origin, int width, int height) const;

private:
    const GlFunctions& gl_;
    ShaderProgram program_;
    GLuint array_ = 0;
    GLuint vertices_ = 0;
};

}  // namespace campuswalk::engine::render
