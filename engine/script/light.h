#pragma once

#include <optional>

#include <Eigen/Core>

namespace campuswalk::engine {

/// How edges are smoothed: several samples per pixel at the edges of surfaces (best for its cost), a filter
/// over the finished image (cheapest, blurs small details), or four pixels drawn for each (most expensive;
/// smooths textures and mirrors too).
enum class AntiAliasing { none, msaa, fxaa, supersampling };

/// Sun, sky and air of images, and how they are drawn (`NAME.light.yaml`). What isn't set is as in daylight.
/// Colours are linear red, green and blue; 1 is what a sheet of paper reflects that is drawn as pure white.
struct LightSettings {
    std::optional<double> sun_azimuth = {};         ///< radians from north (-Z) towards east (+X)
    std::optional<double> sun_elevation = {};       ///< radians above the horizon
    std::optional<Eigen::Vector3d> sun_color = {};  ///< on a surface that faces it; at night the moon's
    std::optional<double> sun_disc = {};  ///< brightness in the sky of the disc and its glow; 0 = hidden

    std::optional<Eigen::Vector3d> zenith_color = {};   ///< the sky overhead
    std::optional<Eigen::Vector3d> horizon_color = {};  ///< the sky at eye level, and distant fog
    std::optional<Eigen::Vector3d> sky_light = {};      ///< on surfaces that face up, even in shadow
    std::optional<Eigen::Vector3d> ground_light = {};   ///< on surfaces that face down
    std::optional<Eigen::Vector3d> room_light = {};     ///< added if the camera is in a room
    /// How bright lamps and other emissive surfaces look: 1 in daylight, more to eyes adapted to the dark.
    std::optional<double> glow = {};

    std::optional<double> fog_distance =
        {};  ///< metres at which an object loses 63 % of its colour; 0 = no fog
    std::optional<bool> shadows = {};
    /// Metres within which corners and things above dim the light of the sky; 0 = nowhere.
    std::optional<double> ambient_occlusion = {};
    std::optional<AntiAliasing> anti_aliasing = {};  ///< msaa by day

    friend bool operator==(const LightSettings&, const LightSettings&) = default;
};

}  // namespace campuswalk::engine
