#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "engine/render/passes/render_settings.h"

namespace campuswalk::engine::render {

/// GLSL constant declarations, to precede the shaders that use them. Whatever is the same for all images of a
/// renderer is a constant, not a uniform: llvmpipe 22.3 reloads uniforms for each pixel of a group of eight
/// (27 instructions each), which took half of a surface's time.
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

/// The lighting constants of the sky chunk and the surface shaders.
ShaderConstants light_constants(const RenderSettings& settings);

}  // namespace campuswalk::engine::render
