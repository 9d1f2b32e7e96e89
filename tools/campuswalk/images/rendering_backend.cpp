#include "tools/campuswalk/images/rendering_backend.h"

#include <stdexcept>

#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/images/images.h"

namespace campuswalk::tools {

bool will_draw(Backend backend) {
    if (backend && backend != engine::render::RenderingBackend::automatic && !can_draw()) {
        throw error_about("--rendering-backend", "bad-value", "this build has no rendering: use none");
    }
    return backend && can_draw();
}

void require_images(Backend backend) {
    if (!backend) {
        throw error_about("--rendering-backend", "bad-value",
                          "'none' draws nothing, and a picture is asked for: use auto, osmesa or egl");
    }
    if (!can_draw()) {
        throw std::runtime_error("this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
    }
}

}  // namespace campuswalk::tools
