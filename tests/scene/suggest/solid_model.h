#pragma once

#include <memory>

#include "collision/mesh/mesh_collider.h"
#include "scene/model/model.h"

namespace campuswalk::scene::test {

/// A model's triangles about the world's origin.
std::shared_ptr<const collision::MeshCollider> solid(const Model& model);

}  // namespace campuswalk::scene::test
