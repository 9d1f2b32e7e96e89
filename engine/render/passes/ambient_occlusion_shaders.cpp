#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kScreenChunk = R"(
vec4 screen_corner() {
    // Depth 0 is the far plane of a reversed depth.
    return vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1, 0.0, 1.0);
}
)";

const std::string_view kScreenVertex = R"(
void main() {
    gl_Position = screen_corner();
}
)";

// Screen-space ambient occlusion: how much of the half space over a pixel's surface is taken by things
// nearer than `radius`, judged from a depth map of what the camera sees.
const std::string_view kOcclusionFragment = R"(
uniform sampler2D depth_map;
uniform vec2 map_size;       // pixels
uniform vec2 ray_scale;      // from a pixel to the ray through its middle, whose z is 1
uniform vec2 ray_offset;
uniform float near_distance;
uniform float radius;             // metres
uniform float pixels_per_radius;  // at a distance of 1 m
out vec2 fragment;                // how open, distance

// Camera frame, z forwards; far away where nothing was drawn.
vec3 position_at(vec2 pixel) {
    vec2 p = clamp(floor(pixel), vec2(0.0), map_size - 1.0);
    float z = near_distance / max(texelFetch(depth_map, ivec2(p), 0).r, 0.00002);
    return vec3(p * ray_scale + ray_offset, 1.0) * z;
}

vec3 shorter(vec3 a, vec3 b) {
    return dot(a, a) < dot(b, b) ? a : b;
}

float taken(vec3 p, vec3 n, vec2 pixel, float per_radius2) {
    vec3 v = position_at(pixel) - p;
    float d2 = dot(v, v);
    float above = dot(v, n) - 0.0024 * p.z - 0.01;  // less the depth map's own error
    return max(0.0, above) * inversesqrt(d2 + 0.0001) * max(0.0, 1.0 - d2 * per_radius2);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec3 p = position_at(pixel);
    // The normal from neighbours; on each axis the nearer one, which is on the same surface.
    vec3 dx = shorter(position_at(pixel + vec2(1, 0)) - p, p - position_at(pixel - vec2(1, 0)));
    vec3 dy = shorter(position_at(pixel + vec2(0, 1)) - p, p - position_at(pixel - vec2(0, 1)));
    vec3 n = normalize(cross(dy, dx));
    float reach = min(pixels_per_radius / p.z, 0.35 * map_size.y);
    // Eight taps on a spiral, turned from pixel to pixel in a 4x4 pattern that the blur removes again.
    int turn = (int(pixel.x) & 3) * 4 + (int(pixel.y) & 3);
    float angle = float((turn * 7) & 15) * 0.3926991;
    vec2 x = reach * vec2(cos(angle), sin(angle));
    vec2 y = vec2(-x.y, x.x);
    float r2 = 1.0 / (radius * radius);
    float sum = taken(p, n, pixel + 0.0625 * x, r2) + taken(p, n, pixel - 0.1383 * x + 0.1267 * y, r2) +
                taken(p, n, pixel + 0.0273 * x - 0.3113 * y, r2) + taken(p, n, pixel + 0.2662 * x + 0.3472 * y, r2) +
                taken(p, n, pixel - 0.5541 * x - 0.0980 * y, r2) + taken(p, n, pixel + 0.5803 * x - 0.3690 * y, r2) +
                taken(p, n, pixel - 0.2111 * x + 0.7845 * y, r2) + taken(p, n, pixel - 0.4329 * x - 0.8320 * y, r2);
    float open = clamp(1.0 - 0.2125 * sum, 0.25, 1.0);
    // Where the radius is a pixel or two there is nothing to see but noise.
    fragment = vec2(mix(1.0, open, smoothstep(1.5, 6.0, reach)), p.z);
}
)";

// Averages the 4x4 pattern away, one axis at a time, but only over pixels at the same depth.
const std::string_view kBlurFragment = R"(
uniform sampler2D occlusion_map;
uniform ivec2 axis;
uniform ivec2 last;  // pixel
out vec2 fragment;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec2 centre = texelFetch(occlusion_map, here, 0).rg;
    vec2 sum = vec2(centre.r, 1.0);
    float sharpness = 12.0 / centre.g;
    for (int i = -2; i <= 1; ++i) {
        if (i != 0) {
            vec2 other = texelFetch(occlusion_map, clamp(here + i * axis, ivec2(0), last), 0).rg;
            sum += max(0.0, 1.0 - sharpness * abs(other.g - centre.g)) * vec2(other.r, 1.0);
        }
    }
    fragment = vec2(sum.x / sum.y, centre.g);
}
)";

}  // namespace campuswalk::engine::render::shaders
