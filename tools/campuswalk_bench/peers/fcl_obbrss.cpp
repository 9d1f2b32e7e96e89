// FCL's tree of oriented boxes and swept spheres, its fastest for a single shape against a mesh, in double,
// as Debian builds it: without -march, since the alignment of Eigen's types is part of its interface.

#include <algorithm>
#include <limits>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/fcl_mesh.h"

namespace campuswalk::tools::bench {

namespace {

class FclObbrss final : public TouchEngine {
public:
    explicit FclObbrss(const collision::TriangleMesh& mesh) { FclMesh(mesh).build(model_); }

    void triangles_near(const collision::Segment& upright, double radius,
                        std::vector<std::uint32_t>& out) override {
        const fcl::Capsuled capsule(radius, (upright.b - upright.a).norm());
        fcl::Transform3d X_mesh_capsule = fcl::Transform3d::Identity();
        // FCL's capsules lie along z.
        X_mesh_capsule.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
        X_mesh_capsule.translation() = 0.5 * (upright.a + upright.b);
        const fcl::CollisionRequestd request(std::numeric_limits<int>::max(), false);
        fcl::CollisionResultd result;
        fcl::collide<double>(&model_, fcl::Transform3d::Identity(), &capsule, X_mesh_capsule, request,
                             result);
        out.clear();
        for (std::size_t i = 0; i < result.numContacts(); ++i) {
            out.push_back(static_cast<std::uint32_t>(result.getContact(i).b1));
        }
        std::sort(out.begin(), out.end());
    }

private:
    fcl::BVHModel<fcl::OBBRSSd> model_;
};

}  // namespace

extern "C" TouchEngine* campuswalk_make_touch_engine(const collision::TriangleMesh& mesh) {
    return new FclObbrss(mesh);
}

}  // namespace campuswalk::tools::bench
