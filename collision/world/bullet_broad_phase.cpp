#include "collision/world/bullet_broad_phase.h"

#include <cmath>
#include <limits>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

namespace campuswalk::collision {

namespace {

// Debian ships a float and a double build of Bullet side by side; mixing headers and library crashes.
static_assert(sizeof(btScalar) == sizeof(float),
              "build against Bullet's float32 library (pkg-config bullet)");

float rounded_down(double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}

float rounded_up(double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

btVector3 lower(const Vec3& p) {
    return {rounded_down(p.x()), rounded_down(p.y()), rounded_down(p.z())};
}

btVector3 upper(const Vec3& p) {
    return {rounded_up(p.x()), rounded_up(p.y()), rounded_up(p.z())};
}

/// Bullet carries the id as the proxy's client pointer; one is added because null means "no client".
void* client_of(ObjectId id) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): Bullet's interface
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(index_of(id)) + 1);
}

ObjectId id_of(const btBroadphaseProxy* proxy) {
    return static_cast<ObjectId>(reinterpret_cast<std::uintptr_t>(proxy->m_clientObject) - 1);
}

struct CollectOverlaps final : btBroadphaseAabbCallback {
    explicit CollectOverlaps(std::vector<ObjectId>& ids) : out(ids) {}
    bool process(const btBroadphaseProxy* proxy) override {
        out.push_back(id_of(proxy));
        return true;
    }
    std::vector<ObjectId>& out;
};

class BulletBroadPhase final : public BroadPhase {
public:
    ~BulletBroadPhase() override {
        for (btBroadphaseProxy* proxy : proxies_) {
            tree_.destroyProxy(proxy, nullptr);
        }
    }
    BulletBroadPhase() = default;
    BulletBroadPhase(const BulletBroadPhase&) = delete;
    BulletBroadPhase& operator=(const BulletBroadPhase&) = delete;

    void insert(ObjectId id, const Aabb& box) override {
        constexpr int kStatic = btBroadphaseProxy::StaticFilter;
        proxies_.push_back(
            tree_.createProxy(lower(box.min), upper(box.max), 0, client_of(id), kStatic, 0, nullptr));
    }

    void overlapping(const Aabb& box, std::vector<ObjectId>& out) const override {
        CollectOverlaps collect(out);
        tree_.aabbTest(lower(box.min), upper(box.max), collect);
    }

    /// By the segment's box: exact enough for a gaze of some metres, and free of the float32 error that
    /// Bullet's own ray test has far from the origin.
    void crossing(const Vec3& from, const Vec3& to, std::vector<ObjectId>& out) const override {
        overlapping({from.cwiseMin(to), from.cwiseMax(to)}, out);
    }

private:
    mutable btDbvtBroadphase tree_;  ///< its queries aren't const
    std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_bullet_broad_phase() {
    return std::make_unique<BulletBroadPhase>();
}

}  // namespace campuswalk::collision
