#include "tests/benchmarks/bullet_rays.h"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

namespace campuswalk::bench {

namespace {

btVector3 bullet(const collision::Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

struct Nearest : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    bool found = false;

    btScalar reportHit(const btVector3& /*normal*/, btScalar fraction, int /*part*/,
                       int /*triangle*/) override {
        found = true;
        return fraction;
    }
};

btIndexedMesh indexed(const collision::TriangleMesh& mesh) {
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

}  // namespace

struct BulletRays::Parts {
    btTriangleIndexVertexArray triangles;
    std::optional<btBvhTriangleMeshShape> shape;
};

BulletRays::BulletRays(const collision::TriangleMesh& mesh) : parts_(std::make_unique<Parts>()) {
    parts_->triangles.addIndexedMesh(indexed(mesh));
    parts_->shape.emplace(&parts_->triangles, true);
}

BulletRays::~BulletRays() = default;

std::optional<double> BulletRays::first_on_ray(const collision::Ray& ray) const {
    Nearest nearest(bullet(ray.from), bullet(ray.to));
    parts_->shape->performRaycast(&nearest, nearest.m_from, nearest.m_to);
    return nearest.found ? std::optional<double>(nearest.m_hitFraction) : std::nullopt;
}

}  // namespace campuswalk::bench
