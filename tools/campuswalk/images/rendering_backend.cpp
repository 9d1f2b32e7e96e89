#include "tools/campuswalk/images/rendering_backend.h"

#include <stdexcept>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/images/images.h"

namespace campuswalk::tools {
namespace {

scene::InputError refused(const char* message) {
    return scene::InputError({"--rendering-backend", 0, 0}, "bad-value", message);
}

}  // namespace

bool wants_images(Backend backend) {
    if (backend && backend != engine::render::RenderingBackend::automatic && !can_draw()) {
        throw refused("this build has no rendering: use none");
    }
    return backend && can_draw();
}

void require_images(Backend backend) {
    if (!backend) {
        throw refused("'none' draws nothing, and a picture is asked for: use auto, osmesa or egl");
    }
    if (!can_draw()) {
        throw std::runtime_error("this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
    }
}

}  // namespace campuswalk::tools
