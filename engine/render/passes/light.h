#pragma once

#include "engine/render/passes/render_settings.h"
#include "engine/script/light.h"

namespace campuswalk::engine::render {

/// `base`, overridden by whatever `light` sets.
RenderSettings apply_light(const RenderSettings& base, const LightSettings& light);

}  // namespace campuswalk::engine::render
