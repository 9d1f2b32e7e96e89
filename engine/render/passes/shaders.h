#pragma once

#include <string_view>

namespace campuswalk::engine::render::shaders {

// GLSL 3.30 sources that several programs share, and those of the renderer itself; other passes keep theirs
// in their own .cpp. A program is kVersion + chunks + its own source. llvmpipe executes both sides of every
// branch and reloads uniforms for every pixel. So there are few branches, whatever is fixed for a renderer is
// a constant (ShaderConstants), and per-image and per-material values reach the fragment shader as flat
// varyings. Positions are in the campus frame (metres from CampusGeometry::origin).

extern const std::string_view kVersion;

/// Needs light_constants. vec3 sky_color(vec3 direction): gradient, haze and sun; vec3 fog_color(vec3
/// direction): the sky at the horizon; vec3 tone_map(vec3 linear).
extern const std::string_view kSkyChunk;
/// vec3 srgb_to_linear(vec3 srgb), vec3 linear_to_srgb(vec3 linear): the transfer function of IEC 61966-2-1.
extern const std::string_view kSrgbChunk;
/// Needs ShadowMaps::constants. float sunlight(vec3 position, vec3 normal, vec2 near_origin): 0 in shadow, 1
/// in the sun; `near_origin` is set by ShadowMaps::bind.
extern const std::string_view kShadowChunk;

/// vec4 full_screen_vertex(): vertices 0 to 2 of a triangle that covers the image at the far plane.
extern const std::string_view kScreenChunk;

/// vec3 instance_position(vec3 position), vec3 instance_normal(vec3 normal): a vertex of an instance in the
/// campus frame; uint instance_node. Exact for the identity instance.
extern const std::string_view kInstanceChunk;

extern const std::string_view kSurfaceVertex;
/// All surface programs; SurfacePrograms selects the variant by #define.
extern const std::string_view kSurfaceFragment;
extern const std::string_view kSkyVertex;
extern const std::string_view kSkyFragment;
extern const std::string_view kDepthVertex;
extern const std::string_view kDepthFragment;        ///< opaque: depth only
extern const std::string_view kMaskedDepthFragment;  ///< discards below the alpha cutoff
extern const std::string_view kScreenVertex;         ///< for full-screen passes

}  // namespace campuswalk::engine::render::shaders
