#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kShadowChunk = R"(
#if defined(NO_SHADOWS)
float sunlight(vec3 position, vec3 normal, vec2 near_origin) {
    return 1.0;
}
#else
// Both maps share one texture, so that a pixel samples only one of them.
uniform sampler2DShadow shadow_map;

float sunlight(vec3 position, vec3 normal, vec2 near_origin) {
    vec3 far = far_axes * position + far_origin;
    vec2 near = far.xy * near_scale + near_origin;
    bool is_near = all(lessThan(abs(near - near_centre), near_half_extent));
    // Offset along the normal by a texel or two against self-shadowing.
    vec3 p = far + far_axes * normal * (is_near ? near_normal_offset : far_normal_offset);
    p.xy = is_near ? p.xy * near_scale + near_origin : p.xy * far_scale;
    // PCF: four samples, each filtered over 2x2 texels, make edges about three texels wide.
    vec3 right_up = vec3(pcf_offset, 0.0);
    vec3 left_up = vec3(-pcf_offset.x, pcf_offset.y, 0.0);
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
uniform float indoor_share;       // weight of the indoor light
uniform vec2 near_origin;       // of the near shadow map, in texture coordinates
uniform vec2 occlusion_scale;   // from pixels to occlusion map coordinates
uniform vec4 base_color;
uniform vec3 emissive;
uniform float reflective;           // 1 for glass and water, which reflect the sky
uniform float alpha_cutoff;
uniform float normal_scale;
uniform vec2 metallic_roughness;       // factors for the map's blue and green channels
out vec3 position;
out vec3 normal;
out vec2 uv;
out vec4 color;
flat out vec4 eye_and_fog;
flat out vec4 shadow_and_occlusion;
flat out vec4 emissive_and_reflective;
flat out vec4 cutoff_and_scales;
flat out float indoor;

void main() {
    position = instance_position(vertex_position);
    normal = instance_normal(vertex_normal);
    uv = vertex_uv;
    color = base_color * vertex_color;
    eye_and_fog = vec4(eye, fog_density);
    shadow_and_occlusion = vec4(near_origin, occlusion_scale);
    emissive_and_reflective = vec4(emissive, reflective);
    cutoff_and_scales = vec4(alpha_cutoff, normal_scale, metallic_roughness);
    indoor = indoor_share;
    gl_Position = clip_campus * vec4(position, 1.0);
}
)";

const std::string_view kSurfaceFragment = R"(
in vec3 position;
in vec3 normal;
in vec2 uv;
in vec4 color;
out vec4 fragment;

flat in vec4 eye_and_fog;
flat in vec4 shadow_and_occlusion;
flat in vec4 emissive_and_reflective;
flat in vec4 cutoff_and_scales;
flat in float indoor;

uniform sampler2D base_color_map;
#if defined(EMISSIVE_MAP)
uniform sampler2D emissive_map;
#endif
#if defined(OCCLUSION)
uniform sampler2D occlusion_map;
#endif

#if defined(NORMAL_MAP)
uniform sampler2D normal_map;

// Tangent frame from the screen-space derivatives of position and texture coordinates (Schueler, "Normal Mapping
// Without Precomputed Tangents", ShaderX 5), so models need no tangents. v points down the texture, the map's y up.
vec3 perturbed_normal(vec3 n) {
    vec3 across_y = cross(dFdy(position), n);
    vec3 across_x = cross(n, dFdx(position));
    vec2 uv_x = dFdx(uv);
    vec2 uv_y = dFdy(uv);
    vec3 along_u = across_y * uv_x.x + across_x * uv_y.x;
    vec3 along_v = across_y * uv_x.y + across_x * uv_y.y;
    float longer = max(dot(along_u, along_u), dot(along_v, along_v));
    vec3 bump = (255.0 / 127.0) * texture(normal_map, uv).xyz - 128.0 / 127.0;
    bump.xy *= cutoff_and_scales.y * inversesqrt(max(longer, 1e-30));
    return normalize(along_u * bump.x - along_v * bump.y + n * bump.z);
}
#endif

#if defined(SPECULAR)
uniform sampler2D metallic_roughness_map;

// Specular reflection of the sun: GGX with Smith masking (Walter et al. 2007; glTF 2.0, appendix B.3). The model
// loses the light scattered between the microfacets of rough metals; these are lit like a matt surface instead.
float sun_specular(vec3 n, vec3 to_eye, float roughness) {
    float a2 = roughness * roughness * roughness * roughness + 0.0001;
    vec3 half_way = normalize(to_sun + to_eye);
    float nh = max(dot(n, half_way), 0.0);
    float nl = max(dot(n, to_sun), 0.0);
    float nv = max(dot(n, to_eye), 0.001);
    float spread = nh * nh * (a2 - 1.0) + 1.0;
    float masking = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2) + 0.0001);
    // Clamped to about a wet road: subpixel highlights would flicker between images.
    float specular = min(a2 / (spread * spread) * masking, 8.0);
    return mix(specular, 1.0, a2);
}
#endif

vec4 output_color(vec3 light, float alpha) {
#if defined(SEE_THROUGH)
    return vec4(light, alpha);  // blended with what is behind it
#else
    return vec4(linear_to_srgb(light), alpha);
#endif
}

// `up` is the y component of the normal.
vec3 ambient_light(float up) {
    return ambient_mean + ambient_gradient * up + room_light * (indoor + indoor * indoor_gradient * up);
}


float ambient_visibility() {
#if defined(OCCLUSION)
    return texture(occlusion_map, gl_FragCoord.xy * shadow_and_occlusion.zw).r;
#else
    return 1.0;
#endif
}

float direct_sun(vec3 n) {
    float facing = dot(n, to_sun);
#if defined(CUTOUT)
    // Leaves are thin: half of the sunlight passes through to their shaded side.
    return max(facing, -0.5 * facing) * sunlight(position, n * sign(facing), shadow_and_occlusion.xy);
#else
    return max(facing, 0.0) * sunlight(position, n, shadow_and_occlusion.xy);
#endif
}

vec3 emission() {
    vec3 glow = emissive_scale * emissive_and_reflective.rgb;
#if defined(EMISSIVE_MAP)
    glow *= srgb_to_linear(texture(emissive_map, uv).rgb);
#endif
    return glow;
}

// Radiance towards the eye, before fog.
vec3 shade(vec3 albedo, vec3 n, vec3 view_ray) {
    float sun = direct_sun(n);
    vec3 light = (ambient_light(n.y) + sky_light * dot(n, side_axis)) * ambient_visibility() + sun_color * sun;
#if defined(SPECULAR)
    vec2 metal = cutoff_and_scales.zw * texture(metallic_roughness_map, uv).bg;
    vec3 f0 = mix(vec3(0.04), albedo, metal.x);
    vec3 reflected = reflect(view_ray, n);
    vec3 surroundings = mix(sky_color(reflected), ambient_light(reflected.y), metal.y) * ambient_visibility();
    float grazing = 1.0 - max(dot(-view_ray, n), 0.0);
    float grazing2 = grazing * grazing;
    vec3 fresnel = f0 + max(vec3(1.0 - metal.y) - f0, 0.0) * (grazing2 * grazing2 * grazing);
    return albedo * (1.0 - metal.x) * light + fresnel * surroundings +
           f0 * sun_specular(n, -view_ray, metal.y) * sun * sun_color + emission();
#else
    return albedo * light + emission();
#endif
}

#if defined(SEE_THROUGH)
// Glass or water: Schlick's Fresnel approximation, with a reflectance of 4 % at normal incidence.
vec4 glass(vec3 own, float alpha, vec3 n, vec3 view_ray) {
    float reflectance = emissive_and_reflective.w * (0.04 + 0.96 * pow(1.0 - max(dot(-view_ray, n), 0.0), 5.0));
    vec3 reflected = reflect(view_ray, n);
    vec3 both = mix(own * alpha, sky_color(vec3(reflected.x, abs(reflected.y), reflected.z)), reflectance);
    float cover = reflectance + (1.0 - reflectance) * alpha;
    return vec4(both / max(cover, 0.001), cover);
}
#endif

void main() {
    vec4 base = texture(base_color_map, uv);
    base.rgb = srgb_to_linear(base.rgb);
    base *= color;
#if defined(CUTOUT)
    // Alpha becomes coverage, so edges are as sharp as the pixel grid, not as the texture.
    base.a = clamp((base.a - cutoff_and_scales.x) / max(fwidth(base.a), 0.0001) + 0.5, 0.0, 1.0);
    if (base.a < 0.02) {
        discard;
    }
#elif !defined(SEE_THROUGH)
    base.a = 1.0;
#endif
    vec3 to_eye = eye_and_fog.xyz - position;
    float squared_distance = max(dot(to_eye, to_eye), 1e-6);
    float per_distance = inversesqrt(squared_distance);
    vec3 view_ray = -to_eye * per_distance;
    float clear = exp(-squared_distance * per_distance * eye_and_fog.w);
#if defined(UNLIT)
    // Unlit colours are final: tone mapping would change them.
    fragment = output_color(mix(tone_map(fog_color(view_ray)), base.rgb, clear), base.a);
#else
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
#if defined(NORMAL_MAP)
    n = perturbed_normal(n);
#endif
    base.rgb = shade(base.rgb, n, view_ray);
#if defined(SEE_THROUGH)
    base = glass(base.rgb, base.a, n, view_ray);
#endif
    fragment = output_color(tone_map(mix(fog_color(view_ray), base.rgb, clear)), base.a);
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
    gl_Position = clip_campus * vec4(instance_position(vertex_position), 1.0);
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
