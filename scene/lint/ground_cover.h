#pragma once

#include "scene/model/model.h"

namespace campuswalk::scene {

/// How much of a model can be walked on in one piece, seen from above on a grid.
struct GroundCover {
    double share = 0.0;        ///< of what the model covers of the plan, the largest connected level part
    double height = 0.0;       ///< world, where that part begins: a twentieth of it lies lower
    double share_below = 0.0;  ///< of the model's area, what lies 1 m or more below that
};

/// `bounds`: the model's, not empty. Level is up to 50 degrees; edges count 0.4 m for a shoulder's breadth.
GroundCover measure_ground(const Model& model, const Bounds& bounds);

/// Whether that is no ground: shreds, tops of walls, or a roof.
bool lacks_ground(const GroundCover& cover);

}  // namespace campuswalk::scene
