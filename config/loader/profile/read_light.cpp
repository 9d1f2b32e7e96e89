#include "config/loader/profile/read_light.h"

#include <array>

#include "config/loader/values/ranges.h"

namespace campuswalk::config {

using engine::AntiAliasing;
using engine::LightSettings;

namespace {

constexpr Range kAzimuth{-360.0, 360.0, false, "degrees"};
// The sun shines down: from below it would light rooms through their floors.
constexpr Range kElevation{1.0, 90.0, false, "degrees"};
constexpr Range kColor{0.0, 100.0, false, ""};
constexpr Range kDisc{0.0, 100.0, false, ""};
constexpr Range kGlow{0.0, 1000.0, false, ""};
constexpr Range kReach{0.0, 10.0, false, "m"};

void read_sun(const CheckedNode& node, LightSettings& light) {
    CheckedMap map(node, "'sun'");
    map.angle("azimuth_deg", kAzimuth, light.sun_azimuth);
    map.angle("elevation_deg", kElevation, light.sun_elevation);
    map.vector("color", kColor, light.sun_color);
    map.number("disc", kDisc, light.sun_disc);
    map.refuse_other_keys();
}

void read_sky(const CheckedNode& node, LightSettings& light) {
    CheckedMap map(node, "'sky'");
    map.vector("zenith", kColor, light.zenith_color);
    map.vector("horizon", kColor, light.horizon_color);
    map.vector("light", kColor, light.sky_light);
    map.refuse_other_keys();
}

}  // namespace

void read_profile_fields(CheckedMap& map, LightSettings& light) {
    constexpr std::array kAntiAliasing = {Choice<AntiAliasing>{"none", AntiAliasing::none},
                                          Choice<AntiAliasing>{"msaa", AntiAliasing::msaa},
                                          Choice<AntiAliasing>{"fxaa", AntiAliasing::fxaa},
                                          Choice<AntiAliasing>{"supersampling", AntiAliasing::supersampling}};
    if (const auto sun = map.find("sun")) {
        read_sun(*sun, light);
    }
    if (const auto sky = map.find("sky")) {
        read_sky(*sky, light);
    }
    map.vector("ground_light", kColor, light.ground_light);
    map.vector("room_light", kColor, light.room_light);
    map.number("glow", kGlow, light.glow);
    map.number("fog_distance", kDistance, light.fog_distance);
    if (const auto shadows = map.find("shadows")) {
        light.shadows = shadows->as_bool();
    }
    map.number("contact_shading", kReach, light.ambient_occlusion);
    if (const auto smoothing = map.find("anti_aliasing")) {
        light.anti_aliasing = smoothing->choice(kAntiAliasing);
    }
}

}  // namespace campuswalk::config
