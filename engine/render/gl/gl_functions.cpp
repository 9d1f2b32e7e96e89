#include "engine/render/gl/gl_functions.h"

#include <string>

#include "engine/render/gl/render_error.h"

namespace campuswalk::engine::render {
namespace {

template <typename Function>
void load(const GlContext& context, const char* name, Function& function) {
    function = reinterpret_cast<Function>(context.procedure(name));
    if (function == nullptr) {
        throw RenderError(std::string(context.backend()) + " has no " + name +
                          ": snapshots need OpenGL 3.3 with ARB_clip_control (any Mesa since 2016)");
    }
}

}  // namespace

GlFunctions load_gl_functions(const GlContext& context) {
    GlFunctions gl;
#define CAMPUSWALK_LOAD(type, name) load(context, "gl" #name, gl.name);
    CAMPUSWALK_GL_FUNCTIONS(CAMPUSWALK_LOAD)
#undef CAMPUSWALK_LOAD
    return gl;
}

}  // namespace campuswalk::engine::render
