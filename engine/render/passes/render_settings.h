#pragma once

#include <Eigen/Core>

namespace campuswalk::engine::render {

/// Lighting, atmosphere and quality of an image. Colours are linear; 1 is pure white before tone mapping.
struct RenderSettings {
    /// Towards the sun, unit length. South-west, 43° high: the visible sides of a box differ in brightness,
    /// and shadows are about as long as objects are tall.
    Eigen::Vector3d to_sun = Eigen::Vector3d(-0.48, 0.68, 0.55).normalized();
    Eigen::Vector3d sun_color = {1.22, 1.10, 0.92};  ///< irradiance facing the sun; late-morning warm
    Eigen::Vector3d sky_light = {0.30, 0.35, 0.43};  ///< ambient on a surface that faces up
    Eigen::Vector3d ground_light = {0.21, 0.20,
                                    0.18};  ///< ambient on a surface that faces down; keeps rooms readable
    /// Share of the sky light that vertical faces towards the sun gain and those away from it lose, so that
    /// walls differ indoors and in shade.
    double side_light = 0.16;
    double sun_disc = 1.0;  ///< brightness of the sun's disc and its glow in the sky; 0 = hidden

    /// Added to the ambient light when the camera is indoors, fading out as more sky is visible: stands for
    /// lamps and eye adaptation. Slightly warm, to balance the blue sky light.
    Eigen::Vector3d room_light = {0.27, 0.25, 0.21};

    /// Scales emissive surfaces: at night the eye adapts.
    double glow = 1.0;

    Eigen::Vector3d zenith_color = {0.13, 0.30, 0.66};   ///< sky overhead
    Eigen::Vector3d horizon_color = {0.62, 0.73, 0.84};  ///< sky at eye level, and the far end of the fog
    double fog_distance = 900.0;  ///< metres at which fog hides 63 % of a colour; 0 = no fog

    /// Texels per side of the campus shadow map. 4096 over a campus of 300 m is 7 cm, the width of a pole's
    /// shadow.
    int shadow_size = 4096;
    /// Texels per side of the finer map around the camera, drawn for every image.
    int near_shadow_size = 1024;
    double near_shadow_radius = 16.0;  ///< metres around the camera: texels of 3 cm
    bool shadows = true;

    /// Samples per pixel: 1 or 4, all that llvmpipe supports; 4 costs about three times 1.
    int samples = 4;
    bool fxaa = false;      ///< anti-aliasing of the finished image
    int supersampling = 1;  ///< 2: drawn at twice the width and height, then downsampled
    /// Radius of screen-space ambient occlusion, metres; 0 = off.
    double ambient_occlusion_radius = 0.9;
    /// Skips occluded batches. Doesn't change the image.
    bool occlusion_culling = true;
    /// Keeps a mesh that is placed very often once. Changes the image by rounding only.
    bool instancing = true;
    /// Size in metres of the cells that triangles are batched by, for culling and front-to-back drawing.
    double cell_size = 20.0;
};

}  // namespace campuswalk::engine::render
