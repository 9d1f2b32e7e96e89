#include "engine/render/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kScreenVertex = R"(
void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// Screen-space ambient occlusion: how much of the half space over a pixel's surface is taken by things
// nearer than `radius`, judged from a depth map of what the camera sees.
const std::string_view kOcclusionFragment = R"(
uniform sampler2D depth_map;
uniform vec2 map_size;       // pixels
uniform vec2 tan_half_fov;   // x, y
uniform float near_distance;
uniform float radius;        // metres
out float fragment;

const int kTaps = 10;

// Camera frame, z forwards; far away where nothing was drawn.
vec3 position_at(vec2 pixel) {
    float depth = texelFetch(depth_map, ivec2(clamp(pixel, vec2(0.0), map_size - 1.0)), 0).r;
    float z = near_distance / max(depth, 0.00002);
    return vec3((2.0 * (floor(pixel) + 0.5) / map_size - 1.0) * tan_half_fov, 1.0) * z;
}

vec3 shorter(vec3 a, vec3 b) {
    return dot(a, a) < dot(b, b) ? a : b;
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec3 p = position_at(pixel);
    // The normal from neighbours; on each axis the nearer one, which is on the same surface.
    vec3 dx = shorter(position_at(pixel + vec2(1, 0)) - p, p - position_at(pixel - vec2(1, 0)));
    vec3 dy = shorter(position_at(pixel + vec2(0, 1)) - p, p - position_at(pixel - vec2(0, 1)));
    vec3 n = normalize(cross(dy, dx));
    float reach = radius / p.z * map_size.y / (2.0 * tan_half_fov.y);  // pixels
    if (reach < 1.5) {
        fragment = 1.0;  // too far away to show
        return;
    }
    reach = min(reach, 0.35 * map_size.y);
    // A spiral, turned from pixel to pixel in a 4x4 pattern that the blur removes again.
    int turn = (int(pixel.x) & 3) * 4 + (int(pixel.y) & 3);
    float angle = float((turn * 7) & 15) * 0.3926991;
    float taken = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        float share = (float(i) + 0.5) / float(kTaps);
        vec2 offset = vec2(cos(angle), sin(angle)) * (reach * share);
        angle += 2.3999632;
        vec3 v = position_at(pixel + offset) - p;
        float d2 = dot(v, v);
        float above = dot(v, n) - 0.012 * p.z * 0.2 - 0.01;
        float falloff = max(0.0, 1.0 - d2 / (radius * radius));
        taken += max(0.0, above) * inversesqrt(d2 + 0.0001) * falloff;
    }
    float open = 1.0 - 1.7 * taken / float(kTaps);
    float fade = smoothstep(1.5, 6.0, reach);
    fragment = mix(1.0, clamp(open, 0.25, 1.0), fade);
}
)";

// Averages the 4x4 pattern away, but only over pixels at the same depth.
const std::string_view kBlurFragment = R"(
uniform sampler2D occlusion_map;
uniform sampler2D depth_map;
uniform vec2 map_size;
out float fragment;

void main() {
    ivec2 centre = ivec2(gl_FragCoord.xy);
    ivec2 last = ivec2(map_size) - 1;
    float depth = texelFetch(depth_map, centre, 0).r;
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -2; y <= 1; ++y) {
        for (int x = -2; x <= 1; ++x) {
            ivec2 p = clamp(centre + ivec2(x, y), ivec2(0), last);
            float w = max(0.0, 1.0 - 12.0 * abs(texelFetch(depth_map, p, 0).r / max(depth, 0.000001) - 1.0)) + 0.001;
            sum += w * texelFetch(occlusion_map, p, 0).r;
            weights += w;
        }
    }
    fragment = sum / weights;
}
)";

}  // namespace campuswalk::engine::render::shaders
