#include "engine/render/passes/line_pass.h"

#include <array>
#include <cstddef>
#include <vector>

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

constexpr double kHiddenShare = 0.16;  // of a line's colour, behind something
constexpr double kHalfWidth = 0.25;    // pixels, in an image 720 high: drawn four times around its place
constexpr double kReferenceHeight = 720.0;

struct LineVertex {
    std::array<float, 3> position;
    std::array<float, 3> color;
};

LineVertex vertex_at(const Eigen::Vector3d& place, const std::array<float, 3>& color) {
    const Eigen::Vector3f p = place.cast<float>();
    return {{p.x(), p.y(), p.z()}, color};
}

}  // namespace

LinePass::LinePass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "lines", {shaders::kVersion, shaders::kLineVertex},
               {shaders::kVersion, shaders::kLineFragment}) {
    gl.GenVertexArrays(1, &array_);
    gl.GenBuffers(1, &vertices_);
    gl.BindVertexArray(array_);
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_);
    constexpr GLsizei stride = sizeof(LineVertex);
    const std::array<std::size_t, 2> offsets = {offsetof(LineVertex, position), offsetof(LineVertex, color)};
    for (GLuint i = 0; i < offsets.size(); ++i) {
        gl.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, stride, buffer_offset(offsets[i]));
        gl.EnableVertexAttribArray(i);
    }
}

void LinePass::draw(std::span<const OverlayLine> lines, const Eigen::Matrix4d& clip_campus,
                    const Eigen::Vector3d& origin, int width, int height) const {
    std::vector<LineVertex> vertices;
    vertices.reserve(2 * lines.size());
    for (const OverlayLine& line : lines) {
        vertices.push_back(vertex_at(line.a - origin, line.color));
        vertices.push_back(vertex_at(line.b - origin, line.color));
    }
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(LineVertex)),
                   vertices.data(), GL_STATIC_DRAW);
    program_.use();
    program_.set("clip_campus", clip_campus);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.DepthMask(GL_FALSE);
    const auto count = static_cast<GLsizei>(vertices.size());
    gl_.DepthFunc(GL_LESS);
    program_.set("shift", Eigen::Vector2d(0, 0));
    program_.set("share", kHiddenShare);
    gl_.DrawArrays(GL_LINES, 0, count);
    gl_.DepthFunc(GL_GEQUAL);
    program_.set("share", 1.0);
    const double half = 2.0 * kHalfWidth * height / kReferenceHeight;  // clip space is two wide
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(-1, 1), std::pair(1, 1)}) {
        program_.set("shift", Eigen::Vector2d(x * half / width, y * half / height));
        gl_.DrawArrays(GL_LINES, 0, count);
    }
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
}

}  // namespace campuswalk::engine::render
