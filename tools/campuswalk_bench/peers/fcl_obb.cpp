// FCL's tree of oriented boxes, in double, as Debian builds it: without -march, since the alignment of
// Eigen's types is part of its interface.

#include <memory>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/fcl_mesh.h"

namespace campuswalk::tools::bench {

namespace {

using collision::TrianglePair;

using Model = fcl::BVHModel<fcl::OBBd>;

class FclObb final : public Engine {
public:
    FclObb(const collision::TriangleMesh& a, const collision::TriangleMesh& b) {
        FclMesh(a).build(a_);
        FclMesh(b).build(b_);
    }

    void set_pose(const collision::Pose& X_a_b) override {
        X_a_b_.linear() = X_a_b.rotation;
        X_a_b_.translation() = X_a_b.translation;
    }

    void all_pairs(std::vector<TrianglePair>& out) override {
        constexpr std::size_t kAll = std::size_t{1} << 24U;
        collide(kAll);
        out.clear();
        for (std::size_t i = 0; i < result_.numContacts(); ++i) {
            out.push_back(pair(i));
        }
    }

    std::optional<TrianglePair> first_pair() override {
        collide(1);
        return result_.isCollision() ? std::optional(pair(0)) : std::nullopt;
    }

private:
    void collide(std::size_t most) {
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

class FclBuilder final : public TreeBuilder {
public:
    explicit FclBuilder(const collision::TriangleMesh& mesh) : mesh_(mesh) {}

    void build() override {
        model_ = std::make_unique<Model>();
        mesh_.build(*model_);
    }
    void discard() override { model_.reset(); }

private:
    FclMesh mesh_;
    std::unique_ptr<Model> model_;
};

}  // namespace

extern "C" Engine* campuswalk_make_engine(const collision::TriangleMesh& a,
                                          const collision::TriangleMesh& b) {
    return new FclObb(a, b);
}

extern "C" TreeBuilder* campuswalk_make_tree_builder(const collision::TriangleMesh& mesh) {
    return new FclBuilder(mesh);
}

}  // namespace campuswalk::tools::bench
