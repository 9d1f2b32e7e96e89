#include "engine/render/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kShadowChunk = R"(
#if defined(NO_SHADOWS)
float sunlight(vec3 position, vec3 normal) {
    return 1.0;
}
#else
// Both maps lie side by side in one texture, so that a pixel pays for one of them only.
uniform sampler2DShadow shadow_map;
uniform mat4 far_shadow_campus;   // to 0..1 within the far map
uniform mat4 near_shadow_campus;
uniform vec4 far_region;          // scale and offset from there to the whole texture
uniform vec4 near_region;
uniform vec2 shadow_texel;        // in the whole texture
uniform vec2 texel_metres;        // far, near
uniform float near_share;         // 0 when no near map was drawn

float sunlight(vec3 position, vec3 normal) {
    // Looked up a texel or two off the surface: a surface must not shadow itself where the map is coarser.
    vec3 near_position = (near_shadow_campus * vec4(position + normal * (1.6 * texel_metres.y), 1.0)).xyz;
    vec3 far_position = (far_shadow_campus * vec4(position + normal * (1.6 * texel_metres.x), 1.0)).xyz;
    vec2 from_centre = abs(near_position.xy - 0.5);
    bool near = max(from_centre.x, from_centre.y) < 0.49 * near_share;
    vec4 region = near ? near_region : far_region;
    vec3 p = near ? near_position : far_position;
    p.xy = p.xy * region.xy + region.zw;
    // Four taps, each already a blend of 2x2 texels: an edge about three texels wide.
    vec2 d = 0.85 * shadow_texel;
    return 0.25 * (texture(shadow_map, p + vec3(d.x, d.y, 0.0)) + texture(shadow_map, p + vec3(-d.x, d.y, 0.0)) +
                   texture(shadow_map, p + vec3(d.x, -d.y, 0.0)) + texture(shadow_map, p + vec3(-d.x, -d.y, 0.0)));
}
#endif
)";

const std::string_view kSurfaceVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 vertex_color;
uniform mat4 clip_campus;
out vec3 position;
out vec3 normal;
out vec2 uv;
out vec4 color;

void main() {
    position = placed(vertex_position);
    normal = turned(vertex_normal);
    uv = vertex_uv;
    color = vertex_color;
    gl_Position = clip_campus * vec4(position, 1.0);
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
uniform vec3 ambient_middle;   // the mean of the light from above and below
uniform vec3 ambient_rise;     // what a surface that faces up gets more, one that faces down less
uniform vec3 side_axis;        // towards the sun's side, as long as the share of sky light it adds
uniform float fog_density;  // per metre
uniform sampler2D base_color_map;
uniform vec4 base_color;
uniform vec3 emissive;
uniform float glow_scale;
#if defined(GLOW_MAP)
uniform sampler2D glow_map;
#endif
uniform float alpha_cutoff;
uniform float glossy;       // 1 for panes and water, which mirror the sky
#if defined(OCCLUSION)
uniform sampler2D occlusion_map;
uniform vec2 occlusion_scale;  // from pixels to the map's coordinates
#endif

#if defined(NORMAL_MAP)
uniform sampler2D normal_map;
uniform float normal_scale;

// The map's axes on the surface, from how place and texture coordinates change from pixel to pixel (Schueler,
// "Normal Mapping Without Precomputed Tangents", ShaderX 5): models need no tangents. v runs down the picture,
// the map's y up.
vec3 bent(vec3 n) {
    vec3 across_y = cross(dFdy(position), n);
    vec3 across_x = cross(n, dFdx(position));
    vec2 uv_x = dFdx(uv);
    vec2 uv_y = dFdy(uv);
    vec3 along_u = across_y * uv_x.x + across_x * uv_y.x;
    vec3 along_v = across_y * uv_x.y + across_x * uv_y.y;
    float longer = max(dot(along_u, along_u), dot(along_v, along_v));
    vec3 bump = (255.0 / 127.0) * texture(normal_map, uv).xyz - 128.0 / 127.0;
    bump.xy *= normal_scale * inversesqrt(max(longer, 1e-30));
    return normalize(along_u * bump.x - along_v * bump.y + n * bump.z);
}
#endif

#if defined(SHINY)
uniform sampler2D metal_map;
uniform vec2 metal_rough;  // factors of the map's blue and green

// The sun's reflection: GGX with Smith's masking (Walter et al. 2007; glTF 2.0, appendix B.3). A rough metal
// passes light on between its bumps, which the formula loses: there it gets as much as a matt surface.
float sun_gleam(vec3 n, vec3 to_eye, float roughness) {
    float a2 = roughness * roughness * roughness * roughness + 0.0001;
    vec3 half_way = normalize(to_sun + to_eye);
    float nh = max(dot(n, half_way), 0.0);
    float nl = max(dot(n, to_sun), 0.0);
    float nv = max(dot(n, to_eye), 0.001);
    float spread = nh * nh * (a2 - 1.0) + 1.0;
    float masking = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2) + 0.0001);
    // No brighter than a wet road: a gleam smaller than a pixel would flicker from picture to picture.
    float gleam = min(a2 / (spread * spread) * masking, 8.0);
    return mix(gleam, 1.0, a2);
}
#endif

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
    vec3 to_eye = eye - position;
    float distance_to_eye = length(to_eye);
    vec3 outwards = -to_eye / max(distance_to_eye, 0.001);
    float clear = exp(-distance_to_eye * fog_density);
#if defined(UNLIT)
    // Its colour is a finished picture's: without the tone curve, which would change it.
    fragment = vec4(mix(tone(fog_color(outwards)), base.rgb, clear), base.a);
#else
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
#if defined(NORMAL_MAP)
    n = bent(n);
#endif
    float facing = dot(n, to_sun);
#if defined(CUTOUT)
    // Leaves and petals are thin: seen from their shady side, half of the sun shines through.
    float sun = max(facing, -0.5 * facing) * sunlight(position, n * sign(facing));
#else
    float sun = max(facing, 0.0) * sunlight(position, n);
#endif
    vec3 ambient = ambient_middle + ambient_rise * n.y + sky_light * dot(n, side_axis);
#if defined(OCCLUSION)
    ambient *= texture(occlusion_map, gl_FragCoord.xy * occlusion_scale).r;
#endif
    vec3 light = ambient + sun_color * sun;
    vec3 glow = glow_scale * emissive;
#if defined(GLOW_MAP)
    glow *= texture(glow_map, uv).rgb;
#endif
#if defined(SHINY)
    vec2 metal = metal_rough * texture(metal_map, uv).bg;
    vec3 straight_on = mix(vec3(0.04), base.rgb, metal.x);
    vec3 mirrored = reflect(outwards, n);
    vec3 surroundings = mix(sky_color(mirrored), ambient_middle + ambient_rise * mirrored.y, metal.y);
    float grazing = 1.0 - max(dot(-outwards, n), 0.0);
    float grazing2 = grazing * grazing;
    vec3 share = straight_on + max(vec3(1.0 - metal.y) - straight_on, 0.0) * (grazing2 * grazing2 * grazing);
#if defined(OCCLUSION)
    surroundings *= texture(occlusion_map, gl_FragCoord.xy * occlusion_scale).r;
#endif
    vec3 result = base.rgb * (1.0 - metal.x) * light + share * surroundings +
                  straight_on * sun_gleam(n, -outwards, metal.y) * sun * sun_color + glow;
#else
    vec3 result = base.rgb * light + glow;
#endif
#if defined(SEE_THROUGH)
    // Schlick's approximation for glass and water: 4 % seen straight on, everything at a grazing angle.
    float mirror = glossy * (0.04 + 0.96 * pow(1.0 - max(dot(-outwards, n), 0.0), 5.0));
    vec3 reflected = reflect(outwards, n);
    result = mix(result * base.a, sky_color(vec3(reflected.x, abs(reflected.y), reflected.z)), mirror);
    base.a = mirror + (1.0 - mirror) * base.a;
    result /= max(base.a, 0.001);
#endif
    result = mix(fog_color(outwards), result, clear);
    fragment = vec4(tone(result), base.a);
#endif
}
)";

const std::string_view kDepthVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 2) in vec2 vertex_uv;
uniform mat4 clip_campus;
out vec2 uv;

void main() {
    uv = vertex_uv;
    gl_Position = clip_campus * vec4(placed(vertex_position), 1.0);
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
