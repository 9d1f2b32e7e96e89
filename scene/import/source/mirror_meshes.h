#pragma once

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A mirroring transform turns triangles inside out: nodes with a negative determinant get a copy of their
/// meshes with the winding flipped, shared among them.
void mirror_meshes(Model& model);

}  // namespace campuswalk::scene
