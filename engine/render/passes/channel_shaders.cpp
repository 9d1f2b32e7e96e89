#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kChannelVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 vertex_color;
uniform mat4 clip_campus;
uniform vec4 camera_plane;    // what it gives for a place is its distance before the camera
uniform usampler2D node_map;  // one texel a vertex
uniform int numbered;         // 0 for the avatar, whose vertices aren't in the map
flat out uint node;
out float away;
out vec3 normal;
out vec2 uv;
out float alpha;

void main() {
    int columns = textureSize(node_map, 0).x;
    uint own = texelFetch(node_map, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).r;
    node = numbered == 0 ? 0u : (instance_node != 0u ? instance_node : own);
    vec4 position = vec4(placed(vertex_position), 1.0);
    away = dot(camera_plane, position);
    normal = turned(vertex_normal);
    uv = vertex_uv;
    alpha = vertex_color.a;
    gl_Position = clip_campus * position;
}
)";

const std::string_view kChannelFragment = R"(
flat in uint node;
in float away;
in vec3 normal;
in vec2 uv;
in float alpha;
layout(location = 0) out uint node_out;
layout(location = 1) out float depth_out;
layout(location = 2) out vec4 normal_out;
uniform sampler2D base_color_map;
uniform vec4 base_color;
uniform float alpha_cutoff;

void main() {
#if defined(CUTOUT)
    if (base_color.a * alpha * texture(base_color_map, uv).a < alpha_cutoff) {
        discard;
    }
#elif defined(SEE_THROUGH)
    if (base_color.a * alpha * texture(base_color_map, uv).a < 0.5) {
        discard;
    }
#endif
    node_out = node;
    depth_out = away;
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
    normal_out = vec4((128.0 + 127.0 * n) / 255.0, 1.0);
}
)";

}  // namespace campuswalk::engine::render::shaders
