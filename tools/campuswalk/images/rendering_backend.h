#pragma once

#include <optional>

#include "engine/render/gl/gl_context.h"

namespace campuswalk::tools {

/// What draws images, from `--rendering-backend`; nullopt: nothing.
using Backend = std::optional<engine::render::RenderingBackend>;

/// Whether images will be drawn. Throws scene::InputError for a backend that this build lacks.
bool will_draw(Backend backend);

/// For a command that has to draw. Throws scene::InputError for `none`, std::runtime_error in a build
/// without rendering.
void require_images(Backend backend);

}  // namespace campuswalk::tools
