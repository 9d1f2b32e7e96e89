#pragma once

#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// A view of a mesh in Bullet's format.
inline btIndexedMesh indexed(const collision::TriangleMesh& mesh) {
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(mesh.triangles.size());
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(mesh.triangles.data());
    part.m_triangleIndexStride = sizeof(mesh.triangles[0]);
    part.m_numVertices = static_cast<int>(mesh.positions.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(mesh.positions.data());
    part.m_vertexStride = sizeof(mesh.positions[0]);
    part.m_vertexType = PHY_FLOAT;
    return part;
}

inline btVector3 bullet(const collision::Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

}  // namespace campuswalk::tools::bench
