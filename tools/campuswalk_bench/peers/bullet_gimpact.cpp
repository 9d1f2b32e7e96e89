// Bullet's GImpact: quantised trees of axis-aligned boxes, float32, one moving mesh against another. It finds
// all pairs of boxes before it tests triangles, so it can't stop at the first.

#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/bullet_mesh.h"

namespace campuswalk::tools::bench {

namespace {

using collision::TrianglePair;

/// A mesh without the margin that shapes have by default.
struct Body {
    explicit Body(const collision::TriangleMesh& mesh) {
        triangles.addIndexedMesh(indexed(mesh));
        shape.emplace(&triangles);
        shape->setMargin(0.0F);
        shape->updateBound();
        object.setCollisionShape(&*shape);
    }

    btTriangleIndexVertexArray triangles;
    std::optional<btGImpactMeshShape> shape;
    btCollisionObject object;
};

/// Records which triangles touch instead of where.
class PairList final : public btManifoldResult {
public:
    PairList(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
             std::vector<TrianglePair>& out)
        : btManifoldResult(a, b), out_(out) {}

    void setShapeIdentifiersA(int /*part*/, int index) override { a_ = index; }
    void setShapeIdentifiersB(int /*part*/, int index) override { b_ = index; }
    void addContactPoint(const btVector3& /*normal*/, const btVector3& /*point*/,
                         btScalar /*depth*/) override {
        const TrianglePair pair{static_cast<std::uint32_t>(a_), static_cast<std::uint32_t>(b_)};
        if (out_.empty() || out_.back() != pair) {
            out_.push_back(pair);
        }
    }

private:
    std::vector<TrianglePair>& out_;
    int a_ = 0;
    int b_ = 0;
};

class BulletGimpact final : public Engine {
public:
    BulletGimpact(const collision::TriangleMesh& a, const collision::TriangleMesh& b)
        : dispatcher_(&configuration_), a_(a), b_(b) {}

    void set_pose(const collision::Pose& X_a_b) override {
        const collision::Mat3& R = X_a_b.rotation;
        const auto number = [](double value) { return static_cast<btScalar>(value); };
        const btMatrix3x3 turn(number(R(0, 0)), number(R(0, 1)), number(R(0, 2)), number(R(1, 0)),
                               number(R(1, 1)), number(R(1, 2)), number(R(2, 0)), number(R(2, 1)),
                               number(R(2, 2)));
        const collision::Vec3& t = X_a_b.translation;
        b_.object.setWorldTransform(btTransform(turn, {number(t.x()), number(t.y()), number(t.z())}));
    }

    void all_pairs(std::vector<TrianglePair>& out) override {
        out.clear();
        const btCollisionObjectWrapper a(nullptr, a_.object.getCollisionShape(), &a_.object,
                                         a_.object.getWorldTransform(), -1, -1);
        const btCollisionObjectWrapper b(nullptr, b_.object.getCollisionShape(), &b_.object,
                                         b_.object.getWorldTransform(), -1, -1);
        btCollisionAlgorithmConstructionInfo construction;
        construction.m_dispatcher1 = &dispatcher_;
        btGImpactCollisionAlgorithm algorithm(construction, &a, &b);
        PairList pairs(&a, &b, out);
        algorithm.processCollision(&a, &b, btDispatcherInfo(), &pairs);
    }

    bool stops_at_first() const override { return false; }
    std::optional<TrianglePair> first_pair() override { return std::nullopt; }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    Body a_;
    Body b_;
};

}  // namespace

extern "C" Engine* campuswalk_make_engine(const collision::TriangleMesh& a,
                                          const collision::TriangleMesh& b) {
    return new BulletGimpact(a, b);
}

}  // namespace campuswalk::tools::bench
