#pragma once

#include <initializer_list>
#include <string_view>

#include <Eigen/Core>

#include "engine/render/gl/gl_functions.h"

namespace campuswalk::engine::render {

/// A linked program. Uniforms are set by name while it is in use; those that the compiler optimized out are
/// ignored. Must not outlive its context.
class ShaderProgram {
public:
    /// Each list is concatenated to one source. Throws RenderError with `name` and the driver's log.
    ShaderProgram(const GlFunctions& gl, std::string_view name,
                  std::initializer_list<std::string_view> vertex,
                  std::initializer_list<std::string_view> fragment);

    void use() const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, double value) const;
    void set(const char* uniform, const Eigen::Vector2i& value) const;
    void set(const char* uniform, const Eigen::Vector2d& value) const;
    void set(const char* uniform, const Eigen::Vector3d& value) const;
    void set(const char* uniform, const Eigen::Vector4d& value) const;
    void set(const char* uniform, const Eigen::Matrix4d& value) const;

private:
    GLint location(const char* uniform) const { return gl_.GetUniformLocation(program_, uniform); }

    const GlFunctions& gl_;
    GLuint program_ = 0;
};

}  // namespace campuswalk::engine::render
