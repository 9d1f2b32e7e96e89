#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// Whether the two closed triangles share a point. Exact for all finite vertices: touching in one point is an
/// overlap. A triangle without area is the segment or the point that its vertices span. Needs the default
/// rounding mode, like orientation().
///
/// In general position this is Guigue & Devillers, "Fast and robust triangle-triangle overlap test using
/// orientation predicates", Journal of Graphics Tools 8(1), 2003.
bool overlap(const Triangle& s, const Triangle& t);

}  // namespace campuswalk::collision
