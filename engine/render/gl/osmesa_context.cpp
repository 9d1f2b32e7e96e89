#include <array>
#include <cstdint>

#include <GL/osmesa.h>

#include "engine/render/gl/dynamic_library.h"
#include "engine/render/gl/gl_context.h"
#include "engine/render/gl/render_error.h"

namespace campuswalk::engine::render {
namespace {

// Function pointers of <GL/osmesa.h>.
struct OsMesaLibrary {
    OSMesaContext (*create)(const int* attributes, OSMesaContext shared) = nullptr;
    void (*destroy)(OSMesaContext) = nullptr;
    GLboolean (*make_current)(OSMesaContext, void* buffer, GLenum type, GLsizei width,
                              GLsizei height) = nullptr;
    OSMESAproc (*proc_address)(const char* name) = nullptr;
};

OsMesaLibrary open_osmesa() {
    const DynamicLibrary library(
        {"libOSMesa.so.8", "libOSMesa.so"},
        "Mesa's off-screen library libOSMesa.so.8 can't be opened: install it (Debian, Ubuntu: apt install "
        "libosmesa6; Fedora: dnf install mesa-libOSMesa)");
    constexpr const char* kAdvice = "install Mesa 17 to 25.0 (Debian: apt install libosmesa6)";
    OsMesaLibrary functions;
    library.load("OSMesaCreateContextAttribs", functions.create, kAdvice);
    library.load("OSMesaDestroyContext", functions.destroy, kAdvice);
    library.load("OSMesaMakeCurrent", functions.make_current, kAdvice);
    library.load("OSMesaGetProcAddress", functions.proc_address, kAdvice);
    return functions;
}

class OsMesaContext final : public GlContext {
public:
    OsMesaContext() : library_(open_osmesa()) {
        // No depth or stencil buffer, as nothing is drawn to the default framebuffer.
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
                "libOSMesa can't create an OpenGL 3.3 core context: install Mesa with llvmpipe "
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
