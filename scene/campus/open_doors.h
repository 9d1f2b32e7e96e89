#pragma once

#include "scene/campus/campus.h"

namespace campuswalk::scene {

/// Takes the triangles of open doors out of the campus' models, so that nothing draws closed what one walks
/// through: nodes named as doors (is_door_name), with their subtrees, that `except` leaves out of a solid
/// collider and no other collider has. They are kept in Campus::open_doors.
void remove_open_doors(Campus& campus);

}  // namespace campuswalk::scene
