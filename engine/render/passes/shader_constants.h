#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "engine/render/passes/render_settings.h"

namespace campuswalk::engine::render {

/// Declarations of GLSL constants, to go before the shaders that use them. What is the same for all images
/// of a renderer is a constant, not a uniform: llvmpipe 22.3 reads each number of a uniform once for each of
/// a group's eight pixels, 27 instructions, and had spent half of a surface's time on that.
class ShaderConstants {
public:
    ShaderConstants& add(std::string_view name, double value);
    ShaderConstants& add(std::string_view name, const Eigen::Vector2d& value);
    ShaderConstants& add(std::string_view name, const Eigen::Vector3d& value);
    ShaderConstants& add(std::string_view name, const Eigen::Matrix3d& value);
    ShaderConstants& add(const ShaderConstants& others);

    std::string_view text() const { return text_; }

private:
    void declare(std::string_view type, std::string_view name, const double* values, Eigen::Index count);

    std::string text_;
};

/// What the air chunk and the surfaces want to know of the light.
ShaderConstants light_constants(const RenderSettings& settings);

}  // namespace campuswalk::engine::render
