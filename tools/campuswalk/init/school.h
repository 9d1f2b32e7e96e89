#pragma once

#include <vector>

#include "tools/campuswalk/init/init_command.h"
#include "tools/campuswalk/init/wavefront.h"

namespace campuswalk::tools::init {

// A school in metres, +Y up, about the middle of its yard; the gate is at z = 15, south. Buildings are walls
// 3 m high with a doorway 2 m wide to the south, and no roof, so that a plan shows what is in them.

/// `minimal`: terrain, library (its door at z = -6), desk. `stairs`: with a gallery 1.7 m up at the east side
/// of the yard and a flight of ten to it. `campus`: with cafeteria (west), gym (east) and benches, too.
std::vector<NamedMesh> school(Template which);

}  // namespace campuswalk::tools::init
