#include "engine/render/gl/gl_context.h"

#include <string>

#include "engine/render/gl/render_error.h"

namespace campuswalk::engine::render {
namespace {

std::unique_ptr<GlContext> make_first_available() {
    std::string first_reason;
    try {
        return make_osmesa_context();
    } catch (const RenderError& error) {
        first_reason = error.what();
    }
    try {
        return make_egl_context();
    } catch (const RenderError& error) {
        throw RenderError("pictures need OSMesa or EGL, and neither can be used.\n  OSMesa: " + first_reason +
                          "\n  EGL: " + error.what() +
                          "\n  Or run without pictures: --rendering-backend none");
    }
}

}  // namespace

std::unique_ptr<GlContext> make_gl_context(RenderingBackend backend) {
    switch (backend) {
        case RenderingBackend::osmesa:
            return make_osmesa_context();
        case RenderingBackend::egl:
            return make_egl_context();
        case RenderingBackend::automatic:
            break;
    }
    return make_first_available();
}

}  // namespace campuswalk::engine::render
