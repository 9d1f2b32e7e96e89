// Bullet's character controller, which moves a capsule by sweeps of the whole shape each tick: up by the step
// height, ahead, and down again. Without dynamics, since nothing else moves.

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>

#include <optional>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/bullet_mesh.h"

namespace campuswalk::tools::bench {

namespace {

static_assert(sizeof(btScalar) == sizeof(float), "Debian's usual build");

/// Settings besides the body's, metres; by default Bullet's defaults.
struct Tuning {
    btScalar mesh_margin = 0.04F;             ///< around triangles
    btScalar allowed_penetration = 0.04F;     ///< of sweeps
    btScalar unrecovered_penetration = 0.2F;  ///< what may remain after a tick
};

/// The best of some twenty combinations, by goals, on the campus of 65 thousand triangles. With recovery from
/// all penetration, the body gets stuck on stairs and in doors; with less recovery, it reaches forbidden
/// goals.
constexpr Tuning kTuned{0.015F, 0.02F, 0.06F};

class BulletCharacter final : public WalkEngine {
public:
    BulletCharacter(const collision::TriangleMesh& mesh, const WalkBody& body, const Tuning& tuning)
        : body_(body),
          tuning_(tuning),
          dispatcher_(&configuration_),
          world_(&dispatcher_, &broad_phase_, &configuration_) {
        triangles_.addIndexedMesh(indexed(mesh));
        mesh_.emplace(&triangles_, true);
        mesh_->setMargin(tuning.mesh_margin);
        ground_.setCollisionShape(&*mesh_);
        ground_.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
        broad_phase_.getOverlappingPairCache()->setInternalGhostPairCallback(&pairs_to_ghosts_);
        world_.getDispatchInfo().m_allowedCcdPenetration = tuning.allowed_penetration;
        world_.addCollisionObject(&ground_, btBroadphaseProxy::StaticFilter,
                                  btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
    }

    ~BulletCharacter() override {
        remove();
        world_.removeCollisionObject(&ground_);
    }

    BulletCharacter(const BulletCharacter&) = delete;
    BulletCharacter& operator=(const BulletCharacter&) = delete;

    void place(const collision::Vec3& foot) override {
        remove();
        capsule_.emplace(static_cast<btScalar>(body_.radius),
                         static_cast<btScalar>(body_.height - 2.0 * body_.radius));
        ghost_.emplace();
        ghost_->setCollisionShape(&*capsule_);
        ghost_->setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
        controller_.emplace(&*ghost_, &*capsule_, static_cast<btScalar>(body_.step_height),
                            btVector3(0.0F, 1.0F, 0.0F));
        // The controller turned the ghost from its own idea of up; `warp` takes that back.
        controller_->warp(bullet(foot + collision::Vec3(0.0, 0.5 * body_.height, 0.0)));
        controller_->setGravity({0.0F, -static_cast<btScalar>(body_.gravity), 0.0F});
        controller_->setMaxSlope(static_cast<btScalar>(body_.max_slope));
        controller_->setMaxPenetrationDepth(tuning_.unrecovered_penetration);
        world_.addCollisionObject(&*ghost_, btBroadphaseProxy::CharacterFilter,
                                  btBroadphaseProxy::StaticFilter | btBroadphaseProxy::DefaultFilter);
    }

    void walk(const collision::Vec3& desired) override {
        controller_->setWalkDirection(bullet(desired));
        controller_->updateAction(&world_, static_cast<btScalar>(body_.tick));
    }

    collision::Vec3 foot() const override {
        const btVector3& at = ghost_->getWorldTransform().getOrigin();
        return {static_cast<double>(at.x()), static_cast<double>(at.y()) - 0.5 * body_.height,
                static_cast<double>(at.z())};
    }

private:
    void remove() {
        if (ghost_) {
            world_.removeCollisionObject(&*ghost_);
        }
    }

    WalkBody body_;
    Tuning tuning_;
    btTriangleIndexVertexArray triangles_;
    std::optional<btBvhTriangleMeshShape> mesh_;
    btCollisionObject ground_;
    btDefaultCollisionConfiguration configuration_;
    btGhostPairCallback pairs_to_ghosts_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broad_phase_;
    btCollisionWorld world_;
    std::optional<btCapsuleShape> capsule_;
    std::optional<btPairCachingGhostObject> ghost_;
    std::optional<btKinematicCharacterController> controller_;
};

}  // namespace

extern "C" WalkEngine* campuswalk_make_walk_engine(const collision::TriangleMesh& mesh,
                                                   const WalkBody& body) {
    return new BulletCharacter(mesh, body, {});
}

extern "C" WalkEngine* campuswalk_make_tuned_walk_engine(const collision::TriangleMesh& mesh,
                                                         const WalkBody& body) {
    return new BulletCharacter(mesh, body, kTuned);
}

}  // namespace campuswalk::tools::bench
