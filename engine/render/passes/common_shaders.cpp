#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kVersion = "#version 330 core\n";

const std::string_view kInstanceChunk = R"(
layout(location = 4) in vec4 instance_x;  // rows of Instance
layout(location = 5) in vec4 instance_y;
layout(location = 6) in vec4 instance_z;
layout(location = 7) in uint instance_node;

vec3 instance_position(vec3 position) {
    vec4 p = vec4(position, 1.0);
    return vec3(dot(instance_x, p), dot(instance_y, p), dot(instance_z, p));
}

// Not normalized: its length is the instance's scale.
vec3 instance_normal(vec3 normal) {
    return vec3(dot(instance_x.xyz, normal), dot(instance_y.xyz, normal), dot(instance_z.xyz, normal));
}
)";

const std::string_view kScreenChunk = R"(
vec4 full_screen_vertex() {
    // Depth is reversed: 0 is the far plane.
    return vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1, 0.0, 1.0);
}
)";

const std::string_view kScreenVertex = R"(
void main() {
    gl_Position = full_screen_vertex();
}
)";

const std::string_view kSkyChunk = R"(
// Haze lit by the sun, wide enough to reach the horizon.
vec3 sun_haze(float towards_sun) {
    float t = max(towards_sun, 0.0);
    t *= t;
    return (0.10 * t * t * t) * sun_color;
}

vec3 fog_color(vec3 direction) {
    return horizon_color + sun_haze(dot(direction.xz, to_sun.xz));
}

vec3 sky_color(vec3 direction) {
    float up = max(direction.y, 0.0);
    // Haze is thickest at the horizon and falls off with the path length through it.
    float haze = exp(-4.5 * up);
    vec3 color = mix(zenith_color, horizon_color, haze);
    float towards_sun = max(dot(direction, to_sun), 0.0);
    float t2 = towards_sun * towards_sun;
    float t8 = t2 * t2 * t2 * t2;
    float t16 = t8 * t8;
    float t64 = t16 * t16 * t16 * t16;
    float disc = 3.0 * smoothstep(0.9994, 0.9998, towards_sun);
    color += sun_haze(towards_sun) +
             (sun_disc * (0.22 * (t64 * t16 * t8 * t2) + disc)) * sun_color * vec3(1.0, 0.92, 0.78);
    // Below the horizon, beyond the campus: distant hazy ground.
    float down = smoothstep(0.0, 0.25, -direction.y);
    return mix(color, horizon_color * vec3(0.62, 0.63, 0.60), down);
}

// Identity up to 0.7, so that materials keep their colours; above it a shoulder compresses the brightest channel
// towards 1 and desaturates slightly.
vec3 tone_map(vec3 linear) {
    const float start = 0.7;
    const float room = 1.0 - start;
    float peak = max(linear.r, max(linear.g, linear.b));
    float over = max(peak - start, 0.0);
    float squeezed = min(peak, start) + room * over / (over + room);
    float share = squeezed / max(peak, 0.0001);
    return mix(linear * share, vec3(squeezed), 0.35 * (1.0 - share));
}
)";

// Approximated here, as the driver would decode each of the eight texels of a trilinear lookup and encode
// each of a pixel's four samples.
const std::string_view kSrgbChunk = R"(
// Within 0.05 of an 8-bit step.
vec3 srgb_to_linear(vec3 srgb) {
    vec3 curve = 0.0010461 + srgb * (0.0284068 + srgb * (0.5603638 + srgb * (0.5265154 - 0.1167877 * srgb)));
    return mix(curve, srgb * (1.0 / 12.92), lessThanEqual(srgb, vec3(0.04045)));
}

// Within 0.1 of an 8-bit step.
vec3 linear_to_srgb(vec3 linear) {
    vec3 root = sqrt(linear);
    vec3 curve = 0.8337435 * root + 0.2981160 * sqrt(root) - (0.0553145 * linear + 0.0769048);
    return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}
)";

const std::string_view kSkyVertex = R"(
uniform vec3 ray_centre;  // world-frame view ray through the image's centre,
uniform vec3 ray_right;   // its offset to the right edge
uniform vec3 ray_up;      // and to the upper edge
out vec3 ray;

void main() {
    gl_Position = full_screen_vertex();
    ray = ray_centre + gl_Position.x * ray_right + gl_Position.y * ray_up;
}
)";

const std::string_view kSkyFragment = R"(
in vec3 ray;
out vec4 fragment;

// Ordered dithering by half an 8-bit step against banding.
float dither(ivec2 p) {
    int x = p.x & 7, y = p.y & 7;
    int v = x ^ y;
    int rank = ((v & 1) << 5) | ((x & 1) << 4) | ((v & 2) << 2) | ((x & 2) << 1) | ((v & 4) >> 1) | ((x & 4) >> 2);
    return (float(rank) + 0.5) / 64.0 - 0.5;
}

void main() {
    vec3 color = tone_map(sky_color(normalize(ray)));
    fragment = vec4(linear_to_srgb(color) + dither(ivec2(gl_FragCoord.xy)) / 255.0, 1.0);
}
)";

}  // namespace campuswalk::engine::render::shaders
