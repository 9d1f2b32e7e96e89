#pragma once

#include <string>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A model without textures as binary glTF 2.0, for editing and walking: its nodes keep their names and
/// order, positions their 32-bit floats, and any reader can read it, as nothing is compressed. The same model
/// gives the same bytes. (write_glb is for looking at: it regroups triangles and needs extensions.)
std::string write_named_glb(const Model& model);

}  // namespace campuswalk::scene
