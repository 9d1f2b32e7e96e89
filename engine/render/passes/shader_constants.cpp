#include "engine/render/passes/shader_constants.h"

#include <array>
#include <charconv>

namespace campuswalk::engine::render {
namespace {

// Extra indoor light on floors, subtracted on ceilings, so that treads and risers differ.
constexpr double kIndoorGradient = 0.18;

// The shortest decimal that round-trips the float; never an int literal, which is another type in GLSL.
std::string literal(double value) {
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(value)).ptr;
    std::string text(digits.data(), end);
    if (text.find_first_of(".e") == std::string::npos) {
        text += ".0";
    }
    return text;
}

}  // namespace

void ShaderConstants::declare(std::string_view type, std::string_view name, const double* values,
                              Eigen::Index count) {
    text_.append("const ").append(type).append(" ").append(name).append(" = ").append(type).append("(");
    for (Eigen::Index i = 0; i < count; ++i) {
        text_.append(i > 0 ? ", " : "").append(literal(values[i]));
    }
    text_.append(");\n");
}

ShaderConstants& ShaderConstants::add(std::string_view name, double value) {
    declare("float", name, &value, 1);
    return *this;
}

ShaderConstants& ShaderConstants::add(std::string_view name, const Eigen::Vector2d& value) {
    declare("vec2", name, value.data(), value.size());
    return *this;
}

ShaderConstants& ShaderConstants::add(std::string_view name, const Eigen::Vector3d& value) {
    declare("vec3", name, value.data(), value.size());
    return *this;
}

// Column-major, in Eigen as in GLSL.
ShaderConstants& ShaderConstants::add(std::string_view name, const Eigen::Matrix3d& value) {
    declare("mat3", name, value.data(), value.size());
    return *this;
}

ShaderConstants& ShaderConstants::add(const ShaderConstants& others) {
    text_ += others.text_;
    return *this;
}

ShaderConstants light_constants(const RenderSettings& settings) {
    const Eigen::Vector3d level(settings.to_sun.x(), 0.0, settings.to_sun.z());
    ShaderConstants constants;
    constants.add("to_sun", Eigen::Vector3d(settings.to_sun.normalized()))
        .add("sun_color", settings.sun_color)
        .add("sun_disc", settings.sun_disc)
        .add("zenith_color", settings.zenith_color)
        .add("horizon_color", settings.horizon_color)
        .add("sky_light", settings.sky_light)
        .add("ambient_mean", Eigen::Vector3d(0.5 * (settings.sky_light + settings.ground_light)))
        .add("ambient_gradient", Eigen::Vector3d(0.5 * (settings.sky_light - settings.ground_light)))
        .add("side_axis", Eigen::Vector3d(settings.side_light * level.normalized()))
        .add("room_light", settings.room_light)
        .add("indoor_gradient", kIndoorGradient)
        .add("emissive_scale", settings.glow);
    return constants;
}

}  // namespace campuswalk::engine::render
