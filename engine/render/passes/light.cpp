#include "engine/render/passes/light.h"

#include <cmath>

namespace campuswalk::engine::render {
namespace {

constexpr int kMsaaSamples = 4;

template <typename Value>
void assign_if_set(Value& value, const std::optional<Value>& replacement) {
    if (replacement) {
        value = *replacement;
    }
}

void set_anti_aliasing(AntiAliasing method, RenderSettings& settings) {
    settings.samples = method == AntiAliasing::msaa ? kMsaaSamples : 1;
    settings.fxaa = method == AntiAliasing::fxaa;
    settings.supersampling = method == AntiAliasing::supersampling ? 2 : 1;
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
    assign_if_set(settings.sun_color, light.sun_color);
    assign_if_set(settings.sun_disc, light.sun_disc);
    assign_if_set(settings.zenith_color, light.zenith_color);
    assign_if_set(settings.horizon_color, light.horizon_color);
    assign_if_set(settings.sky_light, light.sky_light);
    assign_if_set(settings.ground_light, light.ground_light);
    assign_if_set(settings.room_light, light.room_light);
    assign_if_set(settings.glow, light.glow);
    assign_if_set(settings.fog_distance, light.fog_distance);
    assign_if_set(settings.shadows, light.shadows);
    assign_if_set(settings.ambient_occlusion_radius, light.ambient_occlusion);
    if (light.anti_aliasing) {
        set_anti_aliasing(*light.anti_aliasing, settings);
    }
    return settings;
}

}  // namespace campuswalk::engine::render
