// FCL's tree of oriented boxes, in double, as Debian builds it: no -march here, since the alignment of
// Eigen's types is part of its interface.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include "tools/campuswalk/bench/engine.h"

namespace campuswalk::tools::bench {

namespace {

using collision::TrianglePair;

using Model = fcl::BVHModel<fcl::OBBd>;

void fill(Model& model, const collision::TriangleMesh& mesh) {
    std::vector<fcl::Vector3d> positions;
    for (const Eigen::Vector3f& position : mesh.positions) {
        positions.emplace_back(position.cast<double>());
    }
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(positions.size()));
    model.addSubModel(positions, triangles);
    model.endModel();
}

class FclObb final : public Engine {
public:
    FclObb(const collision::TriangleMesh& a, const collision::TriangleMesh& b) {
        fill(a_, a);
        fill(b_, b);
    }

    void set_pose(const collision::Pose& X_a_b) override {
        X_a_b_.linear() = X_a_b.rotation;
        X_a_b_.translation() = X_a_b.translation;
    }

    void all_pairs(std::vector<TrianglePair>& out) override {
        constexpr std::size_t kAll = std::size_t{1} << 24U;
        ask(kAll);
        out.clear();
        for (std::size_t i = 0; i < result_.numContacts(); ++i) {
            out.push_back(pair(i));
        }
    }

    std::optional<TrianglePair> first_pair() override {
        ask(1);
        return result_.isCollision() ? std::optional(pair(0)) : std::nullopt;
    }

private:
    void ask(std::size_t most) {
        const fcl::CollisionRequestd request(most, false);
        result_.clear();
        fcl::collide(&a_, fcl::Transform3d::Identity(), &b_, X_a_b_, request, result_);
    }

    TrianglePair pair(std::size_t i) const {
        const fcl::Contactd& contact = result_.getContact(i);
        return {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)};
    }

    Model a_;
    Model b_;
    fcl::Transform3d X_a_b_ = fcl::Transform3d::Identity();
    fcl::CollisionResultd result_;
};

}  // namespace

extern "C" Engine* campuswalk_make_peer(const collision::TriangleMesh& a, const collision::TriangleMesh& b) {
    return new FclObb(a, b);
}

}  // namespace campuswalk::tools::bench
