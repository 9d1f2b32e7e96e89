#include "engine/render/gl/shader_program.h"

#include <string>
#include <vector>

#include "engine/render/gl/render_error.h"

namespace campuswalk::engine::render {
namespace {

/// Throws RenderError with the driver's log unless `status` is GL_TRUE.
template <typename GetLog>
void check(GLint status, const char* action, std::string_view name, GLuint object, GetLog get_log) {
    if (status == GL_TRUE) {
        return;
    }
    std::string log(2000, '\0');
    GLsizei length = 0;
    get_log(object, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw RenderError(std::string("the OpenGL driver can't ") + action + " the shader '" + std::string(name) +
                      "': " + log);
}

GLuint compile(const GlFunctions& gl, std::string_view name, GLenum kind,
               std::initializer_list<std::string_view> chunks) {
    std::vector<const GLchar*> texts;
    std::vector<GLint> lengths;
    for (const std::string_view chunk : chunks) {
        if (!chunk.empty()) {  // an empty one may be null, which GL rejects
            texts.push_back(chunk.data());
            lengths.push_back(static_cast<GLint>(chunk.size()));
        }
    }
    const GLuint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    gl.CompileShader(shader);
    GLint ok = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    check(ok, "compile", name, shader, gl.GetShaderInfoLog);
    return shader;
}

}  // namespace

ShaderProgram::ShaderProgram(const GlFunctions& gl, std::string_view name,
                             std::initializer_list<std::string_view> vertex,
                             std::initializer_list<std::string_view> fragment)
    : gl_(gl), program_(gl.CreateProgram()) {
    gl.AttachShader(program_, compile(gl, name, GL_VERTEX_SHADER, vertex));
    gl.AttachShader(program_, compile(gl, name, GL_FRAGMENT_SHADER, fragment));
    gl.LinkProgram(program_);
    GLint ok = 0;
    gl.GetProgramiv(program_, GL_LINK_STATUS, &ok);
    check(ok, "link", name, program_, gl.GetProgramInfoLog);
}

void ShaderProgram::use() const {
    gl_.UseProgram(program_);
}

void ShaderProgram::set(const char* uniform, int value) const {
    gl_.Uniform1i(location(uniform), value);
}

void ShaderProgram::set(const char* uniform, double value) const {
    gl_.Uniform1f(location(uniform), static_cast<float>(value));
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2i& value) const {
    gl_.Uniform2i(location(uniform), value.x(), value.y());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2d& value) const {
    const Eigen::Vector2f v = value.cast<float>();
    gl_.Uniform2f(location(uniform), v.x(), v.y());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector3d& value) const {
    const Eigen::Vector3f v = value.cast<float>();
    gl_.Uniform3f(location(uniform), v.x(), v.y(), v.z());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector4d& value) const {
    const Eigen::Vector4f v = value.cast<float>();
    gl_.Uniform4f(location(uniform), v.x(), v.y(), v.z(), v.w());
}

void ShaderProgram::set(const char* uniform, const Eigen::Matrix4d& value) const {
    const Eigen::Matrix4f m = value.cast<float>();
    gl_.UniformMatrix4fv(location(uniform), 1, GL_FALSE, m.data());
}

}  // namespace campuswalk::engine::render
