#include <array>
#include <cstdint>
#include <string>

#include <GL/osmesa.h>
#include <dlfcn.h>

#include "engine/render/gl_context.h"
#include "engine/render/render_error.h"

namespace campuswalk::engine::render {
namespace {

// The functions of <GL/osmesa.h> as pointers: linking them would load 100 MB of driver at every start.
struct OsMesaLibrary {
    OSMesaContext (*create)(const int* attributes, OSMesaContext shared) = nullptr;
    void (*destroy)(OSMesaContext) = nullptr;
    GLboolean (*make_current)(OSMesaContext, void* buffer, GLenum type, GLsizei width,
                              GLsizei height) = nullptr;
    OSMESAproc (*proc_address)(const char* name) = nullptr;
};

template <typename Function>
void load_symbol(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) {
        throw RenderError(std::string("libOSMesa has no ") + name +
                          ": install Mesa 17 to 25.0 (Debian: apt install libosmesa6)");
    }
}

OsMesaLibrary open_library() {
    void* library = nullptr;
    // Never closed: LLVM's threads and exit handlers outlive any context.
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"}) {
        library = dlopen(name, RTLD_LOCAL | RTLD_NOW);
        if (library != nullptr) {
            break;
        }
    }
    if (library == nullptr) {
        throw RenderError(
            "snapshots need Mesa's off-screen library libOSMesa.so.8, which can't be opened: install it "
            "(Debian, "
            "Ubuntu: apt install libosmesa6; Fedora: dnf install mesa-libOSMesa) or run with --no-snapshots");
    }
    OsMesaLibrary functions;
    load_symbol(library, "OSMesaCreateContextAttribs", functions.create);
    load_symbol(library, "OSMesaDestroyContext", functions.destroy);
    load_symbol(library, "OSMesaMakeCurrent", functions.make_current);
    load_symbol(library, "OSMesaGetProcAddress", functions.proc_address);
    return functions;
}

class OsMesaContext final : public GlContext {
public:
    OsMesaContext() : library_(open_library()) {
        // No depth or stencil of its own: nothing is drawn to the default framebuffer.
        const std::array<int, 15> attributes = {OSMESA_FORMAT,
                                                OSMESA_RGBA,
                                                OSMESA_DEPTH_BITS,
                                                0,
                                                OSMESA_STENCIL_BITS,
                                                0,
                                                OSMESA_PROFILE,
                                                OSMESA_CORE_PROFILE,
                                                OSMESA_CONTEXT_MAJOR_VERSION,
                                                3,
                                                OSMESA_CONTEXT_MINOR_VERSION,
                                                3,
                                                0};
        context_ = library_.create(attributes.data(), nullptr);
        if (context_ == nullptr) {
            throw RenderError(
                "libOSMesa refuses an OpenGL 3.3 core context: install Mesa with llvmpipe "
                "(Debian: apt install libosmesa6)");
        }
        OsMesaContext::make_current();
    }

    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;
    ~OsMesaContext() override { library_.destroy(context_); }

    void make_current() override {
        if (library_.make_current(context_, surface_.data(), GL_UNSIGNED_BYTE, kSurfaceSize, kSurfaceSize) !=
            GL_TRUE) {
            throw RenderError("libOSMesa can't make its context current");
        }
    }

    Procedure procedure(const char* name) const override { return library_.proc_address(name); }

    std::string_view backend() const override { return "OSMesa"; }

private:
    static constexpr int kSurfaceSize = 4;  // required, never drawn to

    OsMesaLibrary library_;
    OSMesaContext context_ = nullptr;
    std::array<std::uint8_t, std::size_t{4} * kSurfaceSize * kSurfaceSize> surface_{};
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() {
    return std::make_unique<OsMesaContext>();
}

}  // namespace campuswalk::engine::render
