#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kShadowChunk = R"(
#if defined(NO_SHADOWS)
float sunlight(vec3 position, vec3 normal, vec2 near_start) {
    return 1.0;
}
#else
// Both maps lie side by side in one texture, so that a pixel pays for one of them only.
uniform sampler2DShadow shadow_map;

float sunlight(vec3 position, vec3 normal, vec2 near_start) {
    vec3 far = far_axes * position + far_start;
    vec2 near = far.xy * near_step + near_start;
    bool is_near = all(lessThan(abs(near - near_middle), near_reach));
    // Looked up a texel or two off the surface: a surface must not shadow itself where the map is coarser.
    vec3 p = far + far_axes * normal * (is_near ? near_lift : far_lift);
    p.xy = is_near ? p.xy * near_step + near_start : p.xy * far_step;
    // Four taps, each already a blend of 2x2 texels: an edge about three texels wide.
    vec3 right_up = vec3(tap, 0.0);
    vec3 left_up = vec3(-tap.x, tap.y, 0.0);
    return 0.25 * (texture(shadow_map, p + right_up) + texture(shadow_map, p - right_up) +
                   texture(shadow_map, p + left_up) + texture(shadow_map, p - left_up));
}
#endif
)";

const std::string_view kSurfaceVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 vertex_color;
uniform mat4 clip_campus;
uniform vec3 eye;
uniform float fog_density;      // per metre
uniform float room_share;       // of the light in rooms
uniform vec2 near_offset;       // of the near shadow map
uniform vec2 occlusion_scale;   // from pixels to the occlusion map's coordinates
uniform vec4 base_color;
uniform vec3 emissive;
uniform float glossy;           // 1 for panes and water, which mirror the sky
uniform float alpha_cutoff;
uniform float normal_scale;
uniform vec2 metal_rough;       // factors of the map's blue and green
out vec3 position;
out vec3 normal;
out vec2 uv;
out vec4 color;
flat out vec4 eye_and_fog;
flat out vec4 near_and_occlusion;
flat out vec4 glow_and_gloss;
flat out vec4 cutoff_bumps_metal;
flat out float room;

void main() {
    position = placed(vertex_position);
    normal = turned(vertex_normal);
    uv = vertex_uv;
    color = base_color * vertex_color;
    eye_and_fog = vec4(eye, fog_density);
    near_and_occlusion = vec4(near_offset, occlusion_scale);
    glow_and_gloss = vec4(emissive, glossy);
    cutoff_bumps_metal = vec4(alpha_cutoff, normal_scale, metal_rough);
    room = room_share;
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

flat in vec4 eye_and_fog;
flat in vec4 near_and_occlusion;
flat in vec4 glow_and_gloss;
flat in vec4 cutoff_bumps_metal;
flat in float room;

uniform sampler2D base_color_map;
#if defined(GLOW_MAP)
uniform sampler2D glow_map;
#endif
#if defined(OCCLUSION)
uniform sampler2D occlusion_map;
#endif

#if defined(NORMAL_MAP)
uniform sampler2D normal_map;

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
    bump.xy *= cutoff_bumps_metal.y * inversesqrt(max(longer, 1e-30));
    return normalize(along_u * bump.x - along_v * bump.y + n * bump.z);
}
#endif

#if defined(SHINY)
uniform sampler2D metal_map;

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

vec4 finished(vec3 light, float alpha) {
#if defined(SEE_THROUGH)
    return vec4(light, alpha);  // to be mixed with what is behind it
#else
    return vec4(encoded(light), alpha);
#endif
}

// From all around on a surface that faces up by `rise`, -1 to 1; more of it in rooms.
vec3 light_around(float rise) {
    return ambient_middle + ambient_rise * rise + room_light * (room + room * lamps_above * rise);
}

// How much of it comes to this place past what is near.
float openness() {
#if defined(OCCLUSION)
    return texture(occlusion_map, gl_FragCoord.xy * near_and_occlusion.zw).r;
#else
    return 1.0;
#endif
}

float sun_on(vec3 n) {
    float facing = dot(n, to_sun);
#if defined(CUTOUT)
    // Leaves and petals are thin: seen from their shady side, half of the sun shines through.
    return max(facing, -0.5 * facing) * sunlight(position, n * sign(facing), near_and_occlusion.xy);
#else
    return max(facing, 0.0) * sunlight(position, n, near_and_occlusion.xy);
#endif
}

vec3 glow_here() {
    vec3 glow = glow_scale * glow_and_gloss.rgb;
#if defined(GLOW_MAP)
    glow *= decoded(texture(glow_map, uv).rgb);
#endif
    return glow;
}

// What a surface of this colour sends to the eye, through clear air.
vec3 lit(vec3 paint, vec3 n, vec3 outwards) {
    float sun = sun_on(n);
    vec3 light = (light_around(n.y) + sky_light * dot(n, side_axis)) * openness() + sun_color * sun;
#if defined(SHINY)
    vec2 metal = cutoff_bumps_metal.zw * texture(metal_map, uv).bg;
    vec3 straight_on = mix(vec3(0.04), paint, metal.x);
    vec3 mirrored = reflect(outwards, n);
    vec3 surroundings = mix(sky_color(mirrored), light_around(mirrored.y), metal.y) * openness();
    float grazing = 1.0 - max(dot(-outwards, n), 0.0);
    float grazing2 = grazing * grazing;
    vec3 share = straight_on + max(vec3(1.0 - metal.y) - straight_on, 0.0) * (grazing2 * grazing2 * grazing);
    return paint * (1.0 - metal.x) * light + share * surroundings +
           straight_on * sun_gleam(n, -outwards, metal.y) * sun * sun_color + glow_here();
#else
    return paint * light + glow_here();
#endif
}

#if defined(SEE_THROUGH)
// A pane or water before what is behind it. Schlick's approximation: 4 % is mirrored straight on, everything
// at a grazing angle.
vec4 pane(vec3 own, float alpha, vec3 n, vec3 outwards) {
    float mirror = glow_and_gloss.w * (0.04 + 0.96 * pow(1.0 - max(dot(-outwards, n), 0.0), 5.0));
    vec3 reflected = reflect(outwards, n);
    vec3 both = mix(own * alpha, sky_color(vec3(reflected.x, abs(reflected.y), reflected.z)), mirror);
    float cover = mirror + (1.0 - mirror) * alpha;
    return vec4(both / max(cover, 0.001), cover);
}
#endif

void main() {
    vec4 base = texture(base_color_map, uv);
    base.rgb = decoded(base.rgb);
    base *= color;
#if defined(CUTOUT)
    // The edge is as sharp as the picture, not as the texture: alpha becomes the pixel's coverage.
    base.a = clamp((base.a - cutoff_bumps_metal.x) / max(fwidth(base.a), 0.0001) + 0.5, 0.0, 1.0);
    if (base.a < 0.02) {
        discard;
    }
#elif !defined(SEE_THROUGH)
    base.a = 1.0;
#endif
    vec3 to_eye = eye_and_fog.xyz - position;
    float squared_distance = max(dot(to_eye, to_eye), 1e-6);
    float per_distance = inversesqrt(squared_distance);
    vec3 outwards = -to_eye * per_distance;
    float clear = exp(-squared_distance * per_distance * eye_and_fog.w);
#if defined(UNLIT)
    // Its colour is a finished picture's: without the tone curve, which would change it.
    fragment = finished(mix(tone(fog_color(outwards)), base.rgb, clear), base.a);
#else
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
#if defined(NORMAL_MAP)
    n = bent(n);
#endif
    base.rgb = lit(base.rgb, n, outwards);
#if defined(SEE_THROUGH)
    base = pane(base.rgb, base.a, n, outwards);
#endif
    fragment = finished(tone(mix(fog_color(outwards), base.rgb, clear)), base.a);
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
