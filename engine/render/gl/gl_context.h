#pragma once

#include <memory>
#include <string_view>

namespace campuswalk::engine::render {

/// An OpenGL 3.3 core context without a window. All drawing goes to framebuffer objects of our own, so a
/// backend needs no surface. A new backend is one more .cpp with a make_… function here.
class GlContext {
public:
    using Procedure = void (*)();

    virtual ~GlContext() = default;

    /// Makes the context the calling thread's current one. Throws RenderError when the driver refuses.
    virtual void make_current() = 0;
    /// The entry point of a GL function. Null when the driver knows no such name; some drivers give every
    /// name that begins with "gl" an entry that does nothing.
    virtual Procedure procedure(const char* name) const = 0;
    /// For messages: "OSMesa".
    virtual std::string_view backend() const = 0;
};

/// Where OpenGL comes from. Software drivers of one Mesa draw the same bytes through either.
enum class RenderingBackend {
    automatic,  ///< OSMesa where it can be used, else EGL
    osmesa,
    egl,
};

/// Throws RenderError that says what to install when the machine hasn't got it.
std::unique_ptr<GlContext> make_gl_context(RenderingBackend backend);

/// Software rendering through Mesa's libOSMesa, which is opened here, not linked: programs that draw no
/// image pay nothing for it. Throws RenderError when the library is missing or too old.
std::unique_ptr<GlContext> make_osmesa_context();

/// Through libEGL, opened likewise, without a window system: Mesa's surfaceless platform, where there is none
/// the first device that will. Mesa takes a GPU if there is one. Throws RenderError likewise.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace campuswalk::engine::render
