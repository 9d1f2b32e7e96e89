#include "tests/benchmarks/fcl_capsules.h"

#include <algorithm>
#include <limits>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>

namespace campuswalk::bench {

struct FclCapsules::Parts {
    fcl::BVHModel<fcl::OBBRSSd> model;
};

FclCapsules::FclCapsules(const collision::TriangleMesh& mesh) : parts_(std::make_unique<Parts>()) {
    std::vector<fcl::Vector3d> positions;
    for (const Eigen::Vector3f& position : mesh.positions) {
        positions.emplace_back(position.cast<double>());
    }
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    parts_->model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(positions.size()));
    parts_->model.addSubModel(positions, triangles);
    parts_->model.endModel();
}

FclCapsules::~FclCapsules() = default;

void FclCapsules::triangles_near(const collision::Segment& upright, double radius,
                                 std::vector<std::uint32_t>& out) const {
    const fcl::Capsuled capsule(radius, (upright.b - upright.a).norm());
    fcl::Transform3d X_mesh_capsule = fcl::Transform3d::Identity();
    // FCL's capsules lie along z.
    X_mesh_capsule.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    X_mesh_capsule.translation() = 0.5 * (upright.a + upright.b);
    const fcl::CollisionRequestd request(std::numeric_limits<int>::max(), false);
    fcl::CollisionResultd result;
    fcl::collide<double>(&parts_->model, fcl::Transform3d::Identity(), &capsule, X_mesh_capsule, request,
                         result);
    out.clear();
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
        out.push_back(static_cast<std::uint32_t>(result.getContact(i).b1));
    }
    std::sort(out.begin(), out.end());
}

}  // namespace campuswalk::bench
