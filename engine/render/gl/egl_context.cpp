#include <array>
#include <string>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "engine/render/gl/dynamic_library.h"
#include "engine/render/gl/gl_context.h"
#include "engine/render/gl/render_error.h"

namespace campuswalk::engine::render {
namespace {

constexpr const char* kEglAdvice =
    "install Mesa 18 or newer (Debian, Ubuntu: apt install libegl1 libgl1-mesa-dri; Fedora: dnf install "
    "mesa-libEGL mesa-dri-drivers)";

// Function pointers of <EGL/egl.h> and of its client extensions.
struct EglLibrary {
    decltype(&eglGetProcAddress) proc_address = nullptr;
    decltype(&eglQueryString) query_string = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bind_api = nullptr;
    decltype(&eglChooseConfig) choose_config = nullptr;
    decltype(&eglCreateContext) create_context = nullptr;
    decltype(&eglDestroyContext) destroy_context = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;
    PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
};

EglLibrary open_egl() {
    const DynamicLibrary library({"libEGL.so.1", "libEGL.so"},
                                 std::string("the library libEGL.so.1 can't be opened: ") + kEglAdvice);
    EglLibrary egl;
    library.load("eglGetProcAddress", egl.proc_address, kEglAdvice);
    library.load("eglQueryString", egl.query_string, kEglAdvice);
    library.load("eglInitialize", egl.initialize, kEglAdvice);
    library.load("eglBindAPI", egl.bind_api, kEglAdvice);
    library.load("eglChooseConfig", egl.choose_config, kEglAdvice);
    library.load("eglCreateContext", egl.create_context, kEglAdvice);
    library.load("eglDestroyContext", egl.destroy_context, kEglAdvice);
    library.load("eglMakeCurrent", egl.make_current, kEglAdvice);
    egl.platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.proc_address("eglGetPlatformDisplayEXT"));
    egl.query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.proc_address("eglQueryDevicesEXT"));
    return egl;
}

bool offers(const char* extensions, const std::string& extension) {
    return extensions != nullptr &&
           (' ' + std::string(extensions) + ' ').find(' ' + extension + ' ') != std::string::npos;
}

// All contexts of a process share the display, so it is never closed.
EGLDisplay open_display(const EglLibrary& egl) {
    const char* offered = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<EGLDisplay> displays;
    if (egl.platform_display != nullptr && offers(offered, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(egl.platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
    }
    if (egl.platform_display != nullptr && egl.query_devices != nullptr &&
        offers(offered, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 32> devices{};
        EGLint count = 0;
        egl.query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            displays.push_back(
                egl.platform_display(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr));
        }
    }
    for (EGLDisplay display : displays) {
        if (display != EGL_NO_DISPLAY && egl.initialize(display, nullptr, nullptr) == EGL_TRUE &&
            offers(egl.query_string(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
            return display;
        }
    }
    throw RenderError(std::string("libEGL has no driver that can render without a window: ") + kEglAdvice);
}

class EglContext final : public GlContext {
public:
    EglContext() : egl_(open_egl()), display_(open_display(egl_)) {
        egl_.bind_api(EGL_OPENGL_API);
        const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_MINOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                  EGL_NONE};
        context_ = egl_.create_context(display_, config(), EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT) {
            throw RenderError(std::string("EGL can't create an OpenGL 3.3 core context: ") + kEglAdvice);
        }
        EglContext::make_current();
    }

    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    ~EglContext() override { egl_.destroy_context(display_, context_); }

    void make_current() override {
        egl_.bind_api(EGL_OPENGL_API);  // per thread
        // Release first: EGL skips a context that it believes to be current, although another backend may
        // have made its own current in Mesa since.
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
            throw RenderError("EGL can't make its context current");
        }
    }

    Procedure procedure(const char* name) const override { return egl_.proc_address(name); }

    std::string_view backend() const override { return "EGL"; }

private:
    // Nothing is drawn to a surface, so any config will do, or none where that is supported.
    EGLConfig config() const {
        if (offers(egl_.query_string(display_, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) {
            return EGL_NO_CONFIG_KHR;
        }
        const std::array<EGLint, 5> attributes = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                                  EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        egl_.choose_config(display_, attributes.data(), &config, 1, &count);
        return config;
    }

    EglLibrary egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() {
    return std::make_unique<EglContext>();
}

}  // namespace campuswalk::engine::render
