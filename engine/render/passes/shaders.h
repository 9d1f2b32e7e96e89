#pragma once

#include <string_view>

namespace campuswalk::engine::render::shaders {

// GLSL 3.30 sources. A program is `version` + chunks + its own source. llvmpipe runs both sides of every
// branch and reads uniforms again for every pixel, so there are few branches here, what a renderer knows
// beforehand is a constant (ShaderConstants), and what an image or a material adds comes to surfaces through
// their vertex shader as a flat value. Positions are in the campus frame (metres from
// CampusGeometry::origin).

extern const std::string_view kVersion;

/// Needs light_constants. vec3 sky_color(vec3 direction): gradient, haze and sun. vec3 fog_color(vec3
/// direction): the sky where it meets the ground. vec3 tone(vec3 linear): tone curve.
extern const std::string_view kAirChunk;
/// vec3 decoded(vec3 srgb), vec3 encoded(vec3 linear): IEC 61966-2-1's curve and its inverse.
extern const std::string_view kSrgbChunk;
/// Needs ShadowMaps::constants. float sunlight(vec3 position, vec3 normal, vec2 near_start): 0 in shadow, 1
/// in the sun; `near_start` is ShadowMaps::near_start.
extern const std::string_view kShadowChunk;

/// vec4 screen_corner(): the vertices 0 to 2 make a triangle over the whole image, at the far plane.
extern const std::string_view kScreenChunk;

/// vec3 placed(vec3 position), vec3 turned(vec3 normal): where and how an instance has a vertex; uint
/// instance_node. Exact for what is drawn where its vertices are.
extern const std::string_view kInstanceChunk;

extern const std::string_view kSurfaceVertex;
/// Many programs in one text: opaque as it stands, with holes or glass after one of the next two, and so on
/// for what else SurfaceKind has.
extern const std::string_view kSurfaceFragment;
extern const std::string_view kDefineCutout;
extern const std::string_view kDefineSeeThrough;
extern const std::string_view kSkyVertex;
extern const std::string_view kSkyFragment;
extern const std::string_view kDepthVertex;
extern const std::string_view kDepthFragment;        ///< opaque: nothing to compute
extern const std::string_view kMaskedDepthFragment;  ///< leaves holes where the texture is transparent
/// Numbers instead of colours, one program for each kind of surface as with kSurfaceFragment.
extern const std::string_view kChannelVertex;
extern const std::string_view kChannelFragment;
extern const std::string_view kLineVertex;
extern const std::string_view kLineFragment;
extern const std::string_view kScreenVertex;  ///< for passes over a whole image
extern const std::string_view kOcclusionFragment;
extern const std::string_view kBlurFragment;
/// The farthest depth in each tile of an image; of all samples after the define.
extern const std::string_view kFarthestFragment;
extern const std::string_view kDefineMultisampled;

}  // namespace campuswalk::engine::render::shaders
