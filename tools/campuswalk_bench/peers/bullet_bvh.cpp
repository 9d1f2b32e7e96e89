// Bullet's tree of a static mesh: quantised axis-aligned boxes, float32.

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/bullet_mesh.h"

namespace campuswalk::tools::bench {

namespace {

struct Nearest : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    bool found = false;

    btScalar reportHit(const btVector3& /*normal*/, btScalar fraction, int /*part*/,
                       int /*triangle*/) override {
        found = true;
        return fraction;
    }
};

class BulletBvh final : public RayEngine {
public:
    explicit BulletBvh(const collision::TriangleMesh& mesh) {
        triangles_.addIndexedMesh(indexed(mesh));
        shape_.emplace(&triangles_, true);
    }

    std::optional<double> first_on_ray(const collision::Ray& ray) override {
        Nearest nearest(bullet(ray.from), bullet(ray.to));
        shape_->performRaycast(&nearest, nearest.m_from, nearest.m_to);
        return nearest.found ? std::optional<double>(nearest.m_hitFraction) : std::nullopt;
    }

private:
    btTriangleIndexVertexArray triangles_;
    std::optional<btBvhTriangleMeshShape> shape_;
};

}  // namespace

extern "C" RayEngine* campuswalk_make_ray_engine(const collision::TriangleMesh& mesh) {
    return new BulletBvh(mesh);
}

}  // namespace campuswalk::tools::bench
