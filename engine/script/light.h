#pragma once

#include <optional>

#include <Eigen/Core>

namespace campuswalk::engine {

/// How edges are smoothed: samples a pixel where surfaces end (looks best for its cost), a filter over the
/// finished image (costs least, softens small things), or four pixels drawn for each (costs most; smooths
/// textures and mirrors too).
enum class AntiAliasing { none, msaa, fxaa, supersampling };

/// Sun, sky and air of images, and how they are drawn (`NAME.light.yaml`). What is left out is as by day.
/// Colours are linear red, green and blue; 1 is what a white sheet sends back when it is drawn as pure white.
struct LightSettings {
    std::optional<double> sun_azimuth = {};         ///< radians from north (-Z) towards east (+X)
    std::optional<double> sun_elevation = {};       ///< radians above the horizon
    std::optional<Eigen::Vector3d> sun_color = {};  ///< on a surface that faces it; at night it is the moon's
    std::optional<double> sun_disc = {};  ///< brightness in the sky of the disc and its glow; 0 = hidden

    std::optional<Eigen::Vector3d> zenith_color = {};   ///< the sky overhead
    std::optional<Eigen::Vector3d> horizon_color = {};  ///< the sky at eye level, and the far end of the fog
    std::optional<Eigen::Vector3d> sky_light = {};      ///< that reaches what faces up, even in shadow
    std::optional<Eigen::Vector3d> ground_light = {};   ///< that reaches what faces down
    std::optional<Eigen::Vector3d> room_light = {};     ///< added where the camera stands in a room
    /// How bright lamps and other emissive surfaces look: 1 beside the day's sun, more to an eye used to the
    /// dark.
    std::optional<double> glow = {};

    std::optional<double> fog_distance =
        {};  ///< metres at which 63 % of a thing's colour is lost; 0 = no fog
    std::optional<bool> shadows = {};
    /// Metres within which corners and things above dim the sky's light; 0 = nowhere.
    std::optional<double> ambient_occlusion = {};
    std::optional<AntiAliasing> anti_aliasing = {};  ///< msaa by day

    friend bool operator==(const LightSettings&, const LightSettings&) = default;
};

}  // namespace campuswalk::engine
