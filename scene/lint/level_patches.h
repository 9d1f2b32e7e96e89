#pragma once

#include <cstddef>
#include <vector>

#include "scene/model/model.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

/// Level triangles of one node that face up and are connected at vertices.
struct LevelPatch {
    std::size_t node = 0;
    UprightBox box;
    double area = 0.0;  ///< on the plan, m²
};

/// Level within 3.6 degrees. Vertices nearer than about `weld`, metres, are one. In order of nodes.
std::vector<LevelPatch> level_patches(const Model& model, double weld);

}  // namespace campuswalk::scene
