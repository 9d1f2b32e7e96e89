#pragma once

#include "scene/model/model.h"

namespace campuswalk::scene {

/// The largest connected walkable region of a model, sampled on a grid seen from above.
struct GroundCover {
    double share = 0.0;        ///< of the model's footprint that the region covers
    double height = 0.0;       ///< world, the 5th percentile of the region's heights
    double share_below = 0.0;  ///< of the model's surface area that is over 1 m below that
};

/// `bounds`: the model's, not empty. Walkable is what slopes up to 50 degrees, has headroom, and is 0.4 m
/// from an edge.
GroundCover measure_ground(const Model& model, const Bounds& bounds);

/// Whether the region is too small to be ground (fragments, tops of walls), or a roof.
bool lacks_ground(const GroundCover& cover);

}  // namespace campuswalk::scene
