#pragma once

#include <Eigen/Core>

namespace campuswalk::engine::render {

/// Light, air and cost of an image. Colours are linear; 1 is what a white sheet sends back when it is drawn
/// as pure white without the tone curve.
struct RenderSettings {
    /// Towards the sun, unit length. From the south-west, 43° high: two visible sides of a box differ in
    /// brightness and shadows are about as long as things are tall.
    Eigen::Vector3d to_sun = Eigen::Vector3d(-0.48, 0.68, 0.55).normalized();
    Eigen::Vector3d sun_color = {1.22, 1.10, 0.92};  ///< on a surface that faces the sun; late-morning warm
    Eigen::Vector3d sky_light = {0.30, 0.35, 0.43};  ///< ambient on a surface that faces up
    Eigen::Vector3d ground_light = {0.21, 0.20,
                                    0.18};  ///< ambient on one that faces down; keeps rooms readable
    /// Share of the sky light that vertical faces turned towards the sun gain and those turned away lose, so
    /// that walls of one room or of a house's shady sides can be told apart.
    double side_light = 0.16;
    double sun_disc = 1.0;  ///< brightness in the sky of the sun's disc and its glow; 0 = hidden

    /// Added to the ambient light when the camera is in a room, less of it the more sky is open above: lamps,
    /// and the eye that adapts. A little warm, against the blue of the sky light.
    Eigen::Vector3d room_light = {0.27, 0.25, 0.21};

    /// Emissive surfaces are this much brighter than their materials say: the night's eye.
    double glow = 1.0;

    Eigen::Vector3d zenith_color = {0.13, 0.30, 0.66};   ///< sky overhead
    Eigen::Vector3d horizon_color = {0.62, 0.73, 0.84};  ///< sky at eye level, and the far end of the fog
    double fog_distance = 900.0;  ///< metres at which 63 % of a thing's colour is lost; 0 = no fog

    /// Shadow texels a side. 4096 over a campus of 300 m is 7 cm, the width of a pole's shadow.
    int shadow_size = 4096;
    /// Texels a side of the finer map around the camera, drawn for every image.
    int near_shadow_size = 1024;
    double near_shadow_radius = 16.0;  ///< metres around the camera: 3 cm texels, where blur would be seen
    bool shadows = true;

    /// Samples a pixel: 1 or 4. llvmpipe has no other number; 4 costs about three times 1.
    int samples = 4;
    bool fxaa = false;      ///< edges smoothed in the finished image
    int supersampling = 1;  ///< 2: drawn twice as wide and high, then averaged
    /// Ambient light is dimmed in corners and under things closer than this, metres; 0 = nowhere.
    double ambient_occlusion_radius = 0.9;
    /// What is behind other things is left out as soon as that is known. Images are the same either way.
    bool occlusion_culling = true;
    /// A mesh that is placed very often is kept once. Images are the same but for rounding.
    bool instancing = true;
    /// Metres a side of the cells that triangles are sorted into for culling and drawing front to back.
    double cell_size = 20.0;
};

}  // namespace campuswalk::engine::render
