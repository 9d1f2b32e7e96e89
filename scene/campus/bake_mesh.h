#pragma once

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"
#include "scene/campus/node_selection.h"

namespace campuswalk::scene {

/// A collision mesh about its own origin, so that float32 keeps its precision far from the world's.
struct BakedMesh {
    collision::TriangleMesh mesh;
    collision::Vec3 p_world_origin = collision::Vec3::Zero();  ///< the bounds' centre in whole millimetres
    std::size_t zero_area = 0;  ///< triangles left out because they are thinner than a tenth of a micrometre
};

/// Joins positions that are equal after rounding to float32; triangles keep their order and winding.
BakedMesh bake_mesh(const WorldGeometry& geometry);

/// Whether bake_mesh keeps a triangle of a mesh about this origin, or leaves it out as too thin.
bool is_baked(const collision::Vec3& a, const collision::Vec3& b, const collision::Vec3& c,
              const collision::Vec3& p_world_origin);

/// As bake_mesh, but with every triangle, however thin, so that they have the geometry's indices. If float32
/// represents all positions exactly, as those of an OBJ file, they are unchanged and the origin is the
/// world's.
BakedMesh bake_every_triangle(const WorldGeometry& geometry);

}  // namespace campuswalk::scene
