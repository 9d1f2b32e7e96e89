#pragma once

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A mirroring transform turns triangles inside out: gives nodes with a negative determinant copies of their
/// meshes with flipped winding. The nodes share the copies.
void mirror_meshes(Model& model);

}  // namespace campuswalk::scene
