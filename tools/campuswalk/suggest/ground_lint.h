#pragma once

#include <optional>
#include <string>

#include "engine/walkspace/report/ground_cover.h"
#include "scene/lint/model_report.h"
#include "scene/model/model.h"

namespace campuswalk::tools {

/// The ground of a model, by walking about on it. None for models too small to walk on.
std::optional<engine::GroundCover> ground_of(const scene::Model& model, const scene::ModelReport& report);

/// Appends the lint `no-ground` if there is hardly any.
void lint_ground(const std::optional<engine::GroundCover>& ground, scene::ModelReport& report);

/// "142.8 m² at 0.0 m", or "more than 700 m² at 0.0 m".
std::string ground_text(const engine::GroundCover& ground);

}  // namespace campuswalk::tools
