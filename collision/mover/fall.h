#pragma once

#include "collision/mover/ground_query.h"
#include "collision/mover/move_context.h"
#include "collision/mover/mover.h"

namespace campuswalk::collision {

/// What carries a body where it is. `min_drop`: see find_ground.
Ground underfoot(MoveContext& context, const Vec3& foot, double min_drop);

/// Moves a body in the air for `seconds`, by gravity, by its slide down what is too steep, and by the desired
/// displacement; it may land. The context must be surveyed for that.
void fall(MoveContext& context, MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace);

}  // namespace campuswalk::collision
