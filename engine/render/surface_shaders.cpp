#include "engine/render/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kShadowChunk = R"(
uniform sampler2DShadow far_shadow;
uniform sampler2DShadow near_shadow;
uniform mat4 far_shadow_world;
uniform mat4 near_shadow_world;
uniform vec3 far_texel;   // a texel's width and height in texture coordinates, its size in metres
uniform vec3 near_texel;
uniform float near_share; // 0 when no near map was drawn
uniform float shadows;    // 0 when no map was drawn at all

// Nine taps, each already a blend of 2x2 texels: an edge about three texels wide.
float shadow_taps(sampler2DShadow map, vec3 p, vec2 texel) {
    float sum = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            sum += texture(map, vec3(p.xy + vec2(x, y) * texel, p.z));
        }
    }
    return sum / 9.0;
}

float sunlight(vec3 position, vec3 normal) {
    if (shadows == 0.0) {
        return 1.0;
    }
    // Looked up a texel or two off the surface: a surface must not shadow itself where the map is coarser.
    vec3 near_position = (near_shadow_world * vec4(position + normal * (1.6 * near_texel.z), 1.0)).xyz;
    vec2 from_centre = abs(near_position.xy - 0.5) * 2.0;
    float near_part = near_share * (1.0 - smoothstep(0.8, 0.96, max(from_centre.x, from_centre.y)));
    float lit = 0.0;
    if (near_part > 0.0) {
        lit = near_part * shadow_taps(near_shadow, near_position, near_texel.xy);
    }
    if (near_part < 1.0) {
        vec3 far_position = (far_shadow_world * vec4(position + normal * (1.6 * far_texel.z), 1.0)).xyz;
        lit += (1.0 - near_part) * shadow_taps(far_shadow, far_position, far_texel.xy);
    }
    return lit;
}
)";

const std::string_view kSurfaceVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 vertex_color;
uniform mat4 clip_campus;
invariant gl_Position;
out vec3 position;
out vec3 normal;
out vec2 uv;
out vec4 color;

void main() {
    position = vertex_position;
    normal = vertex_normal;
    uv = vertex_uv;
    color = vertex_color;
    gl_Position = clip_campus * vec4(vertex_position, 1.0);
}
)";

// Separate programs, not a branch: a shader that can discard is run before its depth test, so every hidden
// wall would be lit in full.
const std::string_view kDefineCutout = "#define CUTOUT\n";
const std::string_view kDefineSeeThrough = "#define SEE_THROUGH\n";

const std::string_view kSurfaceFragment = R"(
in vec3 position;
in vec3 normal;
in vec2 uv;
in vec4 color;
out vec4 fragment;

uniform vec3 eye;
uniform vec3 sky_light;
uniform vec3 ground_light;
uniform float side_light;
uniform float fog_density;  // per metre
uniform sampler2D base_color_map;
uniform vec4 base_color;
uniform vec3 emissive;
uniform float alpha_cutoff;
uniform float glossy;       // 1 for panes and water, which mirror the sky
uniform sampler2D occlusion_map;
uniform vec2 occlusion_scale;  // from pixels to the map's coordinates; 0 without a map

vec3 ambient(vec3 n) {
    vec3 light = mix(ground_light, sky_light, 0.5 + 0.5 * n.y);
    return light + sky_light * (side_light * dot(n.xz, normalize(to_sun.xz)));
}

void main() {
    vec4 base = base_color * color * texture(base_color_map, uv);
#if defined(CUTOUT)
    // The edge is as sharp as the picture, not as the texture: alpha becomes the pixel's coverage.
    base.a = clamp((base.a - alpha_cutoff) / max(fwidth(base.a), 0.0001) + 0.5, 0.0, 1.0);
    if (base.a < 0.02) {
        discard;
    }
#elif !defined(SEE_THROUGH)
    base.a = 1.0;
#endif
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
    float facing = dot(n, to_sun);
    float sun = facing > 0.0 ? facing * sunlight(position, n) : 0.0;
    float open = occlusion_scale.x > 0.0 ? texture(occlusion_map, gl_FragCoord.xy * occlusion_scale).r : 1.0;
    vec3 light = ambient(n) * open + sun_color * sun;
    vec3 result = base.rgb * light + emissive;

    vec3 to_eye = eye - position;
    float distance_to_eye = length(to_eye);
    vec3 outwards = -to_eye / max(distance_to_eye, 0.001);
#if defined(SEE_THROUGH)
    if (glossy > 0.0) {
        // Schlick's approximation for glass and water: 4 % seen straight on, everything at a grazing angle.
        float mirror = 0.04 + 0.96 * pow(1.0 - max(dot(-outwards, n), 0.0), 5.0);
        vec3 reflected = reflect(outwards, n);
        result = mix(result * base.a, sky_color(vec3(reflected.x, abs(reflected.y), reflected.z)), mirror);
        base.a = mirror + (1.0 - mirror) * base.a;
        result /= max(base.a, 0.001);
    }
#endif
    if (fog_density > 0.0) {
        float clear = exp(-distance_to_eye * fog_density);
        result = mix(sky_color(vec3(outwards.x, 0.0, outwards.z)), result, clear);
    }
    fragment = vec4(tone(result), base.a);
}
)";

const std::string_view kDepthVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 2) in vec2 vertex_uv;
uniform mat4 clip_campus;
invariant gl_Position;
out vec2 uv;

void main() {
    uv = vertex_uv;
    gl_Position = clip_campus * vec4(vertex_position, 1.0);
}
)";

const std::string_view kDepthFragment = R"(
void main() {}
)";

const std::string_view kMaskedDepthFragment = R"(
in vec2 uv;
uniform sampler2D base_color_map;
uniform vec4 base_color;
uniform float alpha_cutoff;

void main() {
    if (base_color.a * texture(base_color_map, uv).a < alpha_cutoff) {
        discard;
    }
}
)";

}  // namespace campuswalk::engine::render::shaders
