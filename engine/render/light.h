#pragma once

#include "engine/light.h"
#include "engine/render/render_settings.h"

namespace campuswalk::engine::render {

/// `base` with what `light` says in the place of its own.
RenderSettings lit(const RenderSettings& base, const LightSettings& light);

}  // namespace campuswalk::engine::render
