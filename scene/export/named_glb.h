#pragma once

#include <span>
#include <string>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A model as binary glTF 2.0, for editing and walking: its nodes keep their names and order, positions their
/// 32-bit floats, and any reader can read it, as nothing is compressed. Hierarchies and transforms aren't
/// written, nor are textures other than the base colour's, whose PNG files are `images`, one per texture. The
/// same model gives the same bytes. (write_glb is for looking at: it regroups triangles and needs
/// extensions.)
std::string write_named_glb(const Model& model, std::span<const std::string> images = {});

}  // namespace campuswalk::scene
