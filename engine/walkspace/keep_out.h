#pragma once

#include <functional>
#include <vector>

#include "collision/mover/mover_settings.h"
#include "engine/script/step.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Whether a body with its feet there is where it is to avoid: it touches one of the objects or is in it, or
/// its feet are within the radius of a point. Empty if nothing is avoided. The campus must outlive it.
std::function<bool(const collision::Vec3& foot)> keep_out_of(const scene::Campus& campus,
                                                             const std::vector<Avoided>& avoided,
                                                             const collision::MoverSettings& body);

}  // namespace campuswalk::engine
