#pragma once

#include <memory>
#include <string_view>

namespace campuswalk::engine::render {

/// An OpenGL 3.3 core context without a window. All drawing goes to framebuffer objects, so a backend needs
/// no surface. A new backend is a .cpp with a make_…_context function declared here.
class GlContext {
public:
    using Procedure = void (*)();

    virtual ~GlContext() = default;

    /// Makes the context current on the calling thread. Throws RenderError if the driver refuses.
    virtual void make_current() = 0;
    /// The entry point of a GL function, null if the driver doesn't know it. Some drivers return a no-op for
    /// every name that begins with "gl".
    virtual Procedure procedure(const char* name) const = 0;
    /// For messages: "OSMesa".
    virtual std::string_view backend() const = 0;
};

/// How OpenGL is loaded. The software driver of one Mesa version draws the same bytes through either.
enum class RenderingBackend {
    automatic,  ///< OSMesa if available, else EGL
    osmesa,
    egl,
};

/// Throws RenderError that says what to install if the backend is unavailable.
std::unique_ptr<GlContext> make_gl_context(RenderingBackend backend);

/// Software rendering through Mesa's libOSMesa, opened at run time: programs that draw nothing don't load it.
/// Throws RenderError if the library is missing or too old.
std::unique_ptr<GlContext> make_osmesa_context();

/// Rendering through libEGL without a window system: Mesa's surfaceless platform or else the first usable
/// device, a GPU if there is one. Opened at run time; throws like make_osmesa_context.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace campuswalk::engine::render
