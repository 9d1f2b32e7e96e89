#include "engine/render/passes/light.h"

#include <cmath>

namespace campuswalk::engine::render {
namespace {

constexpr int kMsaaSamples = 4;

template <typename Value>
void replace(Value& value, const std::optional<Value>& by) {
    if (by) {
        value = *by;
    }
}

void set_anti_aliasing(AntiAliasing how, RenderSettings& settings) {
    settings.samples = how == AntiAliasing::msaa ? kMsaaSamples : 1;
    settings.fxaa = how == AntiAliasing::fxaa;
    settings.supersampling = how == AntiAliasing::supersampling ? 2 : 1;
}

}  // namespace

RenderSettings apply_light(const RenderSettings& base, const LightSettings& light) {
    RenderSettings settings = base;
    if (light.sun_azimuth || light.sun_elevation) {
        const Eigen::Vector3d& from = base.to_sun;
        const double azimuth = light.sun_azimuth.value_or(std::atan2(from.x(), -from.z()));
        const double elevation = light.sun_elevation.value_or(std::asin(from.normalized().y()));
        settings.to_sun = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                           -std::cos(elevation) * std::cos(azimuth)};
    }
    replace(settings.sun_color, light.sun_color);
    replace(settings.sun_disc, light.sun_disc);
    replace(settings.zenith_color, light.zenith_color);
    replace(settings.horizon_color, light.horizon_color);
    replace(settings.sky_light, light.sky_light);
    replace(settings.ground_light, light.ground_light);
    replace(settings.room_light, light.room_light);
    replace(settings.glow, light.glow);
    replace(settings.fog_distance, light.fog_distance);
    replace(settings.shadows, light.shadows);
    replace(settings.ambient_occlusion_radius, light.ambient_occlusion);
    if (light.anti_aliasing) {
        set_anti_aliasing(*light.anti_aliasing, settings);
    }
    return settings;
}

}  // namespace campuswalk::engine::render
