#pragma once

#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// Ground that an adult walks about on, in one piece or in several, such as rooms behind closed doors.
struct GroundCover {
    double area = 0.0;          ///< m², each level counted; without its edges
    bool is_cut_short = false;  ///< there is more: it wasn't explored any further
    double seen = 0.0;          ///< m²: `area`, or if that was cut short what looks like ground from above
    double share = 0.0;         ///< of the world's footprint, at most 1; partly estimated if it was cut short
    double height = 0.0;        ///< the 5th percentile of its heights, of the largest piece
    double share_below = 0.0;   ///< of the area of triangles that don't face down: over 2 m below that
};

/// The ground of the world, from the largest piece on. Where that may be is found by looking at the middles
/// of wide columns; then it is walked about on, until there is more of it than needs to be known. Where there
/// are so many triangles that walking would take long, it is only looked at.
GroundCover measure_ground(const WorkerWorlds& worlds);

/// Whether it is too small to be ground (fragments, tops of walls), or a roof.
bool lacks_ground(const GroundCover& cover);
/// Whether most of the world lies below it.
bool is_roof(const GroundCover& cover);

}  // namespace campuswalk::engine
