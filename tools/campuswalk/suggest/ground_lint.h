#pragma once

#include <optional>
#include <string>

#include "engine/walkspace/report/ground_cover.h"
#include "scene/lint/model_report.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

/// The ground of a model, by walking about on it. None for models too small to walk on.
std::optional<engine::GroundCover> ground_of(const UprightModel& upright);

/// Appends the lint `no-ground` if there is hardly any.
void lint_ground(const std::optional<engine::GroundCover>& ground, scene::ModelReport& report);

/// "142 m² at 0.00 m", or if it wasn't all walked on "about 3.2 ha at 0.00 m".
std::string ground_text(const engine::GroundCover& ground);

}  // namespace campuswalk::tools
