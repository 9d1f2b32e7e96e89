#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kLineVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_color;
uniform mat4 clip_campus;
uniform vec2 shift;  // in clip space
out vec3 color;

void main() {
    color = vertex_color;
    gl_Position = clip_campus * vec4(vertex_position, 1.0);
    gl_Position.xy += shift * gl_Position.w;
    // A little nearer, as depth is reversed: a line on a surface is before it.
    gl_Position.z *= 1.003;
}
)";

const std::string_view kLineFragment = R"(
in vec3 color;
uniform float share;
out vec4 fragment;

void main() {
    fragment = vec4(color, share);
}
)";

}  // namespace campuswalk::engine::render::shaders
