#include "engine/render/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kVersion = "#version 330 core\n";

const std::string_view kAirChunk = R"(
uniform vec3 to_sun;
uniform vec3 sun_color;
uniform float sun_disc;
uniform vec3 zenith_color;
uniform vec3 horizon_color;

// Around the sun, even down to the horizon: the haze it lights up.
vec3 wide_glow(float towards_sun) {
    float t = max(towards_sun, 0.0);
    t *= t;
    return (0.10 * t * t * t) * sun_color;
}

vec3 fog_color(vec3 direction) {
    return horizon_color + wide_glow(dot(direction.xz, to_sun.xz));
}

vec3 sky_color(vec3 direction) {
    float up = max(direction.y, 0.0);
    // The haze is thickest at the horizon: its share falls off with the length of the way through it.
    float haze = exp(-4.5 * up);
    vec3 color = mix(zenith_color, horizon_color, haze);
    float towards_sun = max(dot(direction, to_sun), 0.0);
    float disc = 3.0 * smoothstep(0.9994, 0.9998, towards_sun);
    color += wide_glow(towards_sun) +
             (sun_disc * (0.22 * pow(towards_sun, 90.0) + disc)) * sun_color * vec3(1.0, 0.92, 0.78);
    // Below the horizon, where the campus ends: the ground's far haze.
    float down = smoothstep(0.0, 0.25, -direction.y);
    return mix(color, horizon_color * vec3(0.62, 0.63, 0.60), down);
}

// Identity up to 0.7, so that materials keep the colours they were painted with; a shoulder above that takes
// the brightest channel towards 1 and the others along, a little faded, as bright things look.
vec3 tone(vec3 linear) {
    const float start = 0.7;
    const float room = 1.0 - start;
    float peak = max(linear.r, max(linear.g, linear.b));
    float over = max(peak - start, 0.0);
    float squeezed = min(peak, start) + room * over / (over + room);
    float share = squeezed / max(peak, 0.0001);
    return mix(linear * share, vec3(squeezed), 0.35 * (1.0 - share));
}
)";

const std::string_view kSkyVertex = R"(
uniform vec3 ray_centre;  // world direction through the picture's centre, and its change to the
uniform vec3 ray_right;   // right and
uniform vec3 ray_up;      // upper edges
out vec3 ray;

void main() {
    gl_Position = screen_corner();
    ray = ray_centre + gl_Position.x * ray_right + gl_Position.y * ray_up;
}
)";

const std::string_view kSkyFragment = R"(
in vec3 ray;
out vec4 fragment;

// Half a step of an 8-bit sRGB value either way: without it the gradient shows bands.
float dither(ivec2 p) {
    int x = p.x & 7, y = p.y & 7;
    int v = x ^ y;
    int rank = ((v & 1) << 5) | ((x & 1) << 4) | ((v & 2) << 2) | ((x & 2) << 1) | ((v & 4) >> 1) | ((x & 4) >> 2);
    return (float(rank) + 0.5) / 64.0 - 0.5;
}

void main() {
    vec3 color = tone(sky_color(normalize(ray)));
    vec3 root = sqrt(color) + dither(ivec2(gl_FragCoord.xy)) / 255.0;
    fragment = vec4(root * root, 1.0);
}
)";

}  // namespace campuswalk::engine::render::shaders
