#include "engine/render/passes/line_pass.h"

#include <array>
#include <cstddef>
#include <vector>

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

constexpr std::string_view kLineVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_color;
uniform mat4 clip_campus;
uniform vec2 shift;  // in clip space
out vec3 color;

void main() {
    color = vertex_color;
    gl_Position = clip_campus * vec4(vertex_position, 1.0);
    gl_Position.xy += shift * gl_Position.w;
    // Slightly nearer (depth is reversed), so that a line on a surface is in front of it.
    gl_Position.z *= 1.003;
}
)";

constexpr std::string_view kLineFragment = R"(
in vec3 color;
uniform float alpha;
out vec4 fragment;

void main() {
    fragment = vec4(color, alpha);
}
)";

constexpr double kOccludedAlpha = 0.16;  // opacity of an occluded line
constexpr double kHalfWidth =
    0.25;  // pixels, in an image 720 high: each line is drawn four times with this offset
constexpr double kReferenceHeight = 720.0;

struct LineVertex {
    std::array<float, 3> position;
    std::array<float, 3> color;
};

LineVertex line_vertex(const Eigen::Vector3d& position, const std::array<float, 3>& color) {
    const Eigen::Vector3f p = position.cast<float>();
    return {{p.x(), p.y(), p.z()}, color};
}

}  // namespace

LinePass::LinePass(const GlFunctions& gl)
    : gl_(gl), program_(gl, "lines", {shaders::kVersion, kLineVertex}, {shaders::kVersion, kLineFragment}) {
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
        vertices.push_back(line_vertex(line.a - origin, line.color));
        vertices.push_back(line_vertex(line.b - origin, line.color));
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
    program_.set("alpha", kOccludedAlpha);
    gl_.DrawArrays(GL_LINES, 0, count);
    gl_.DepthFunc(GL_GEQUAL);
    program_.set("alpha", 1.0);
    const double half = 2.0 * kHalfWidth * height / kReferenceHeight;  // clip space is two wide
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(-1, 1), std::pair(1, 1)}) {
        program_.set("shift", Eigen::Vector2d(x * half / width, y * half / height));
        gl_.DrawArrays(GL_LINES, 0, count);
    }
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
}

}  // namespace campuswalk::engine::render
