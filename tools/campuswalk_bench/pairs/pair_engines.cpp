#include "tools/campuswalk_bench/pairs/pair_engines.h"

#include <exception>
#include <map>
#include <stdexcept>

#include "collision/hybrid/hybrid_tree.h"
#include "collision/hybrid/hybrid_tree_contacts.h"
#include "collision/mesh/mesh_collider.h"
#include "collision/mesh/mesh_contacts.h"
#include "tools/campuswalk_bench/engines/node_tests.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"

namespace campuswalk::tools::bench {

using collision::HybridContactStatistics;
using collision::MeshCollider;
using collision::Pose;
using collision::SimdTarget;
using collision::TriangleMesh;
using collision::TrianglePair;

namespace {

using collision::HybridMesh;

/// The program's own queries.
struct LibraryQueries {
    static void all_pairs(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                          std::vector<TrianglePair>& out, HybridContactStatistics& work) {
        collision::all_contacts(a, b, X_a_b, out, work);
    }
    static std::optional<TrianglePair> first_pair(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                                  HybridContactStatistics& work) {
        return collision::first_contact(a, b, X_a_b, work);
    }
};

/// The same with another test of nodes.
template <typename NodeTest>
struct QueriesWith {
    static constexpr auto all_pairs = collision::all_contacts_by<NodeTest>;
    static constexpr auto first_pair = collision::first_contact_by<NodeTest>;
};

template <typename Queries>
class HybridEngine final : public Engine {
public:
    HybridEngine(const TriangleMesh& a, const TriangleMesh& b)
        : tree_a_(build_hybrid_tree(a)), tree_b_(build_hybrid_tree(b)), a_{a, tree_a_}, b_{b, tree_b_} {}

    void set_pose(const Pose& X_a_b) override { X_a_b_ = X_a_b; }

    void all_pairs(std::vector<TrianglePair>& out) override {
        work_ = {};
        Queries::all_pairs(a_, b_, X_a_b_, out, work_);
    }

    std::optional<TrianglePair> first_pair() override {
        work_ = {};
        return Queries::first_pair(a_, b_, X_a_b_, work_);
    }

    std::optional<HybridContactStatistics> work() const override { return work_; }

private:
    collision::HybridTree tree_a_;
    collision::HybridTree tree_b_;
    collision::HybridMesh a_;
    collision::HybridMesh b_;
    Pose X_a_b_;
    HybridContactStatistics work_;
};

class Bvh8Engine final : public Engine {
public:
    Bvh8Engine(const TriangleMesh& a, const TriangleMesh& b, SimdTarget simd_target)
        : a_(a, collision::TreeKind::bvh8, collision::Interior::unknown),
          b_(b, collision::TreeKind::bvh8, collision::Interior::unknown),
          simd_target_(simd_target) {}

    void set_pose(const Pose& X_a_b) override { X_a_b_ = X_a_b; }

    void all_pairs(std::vector<TrianglePair>& out) override {
        work_ = {};
        all_contacts(a_, b_, X_a_b_, out, &work_, simd_target_);
    }

    std::optional<TrianglePair> first_pair() override {
        work_ = {};
        return first_contact(a_, b_, X_a_b_, &work_, simd_target_);
    }

    std::optional<HybridContactStatistics> work() const override { return work_; }

private:
    MeshCollider a_;
    MeshCollider b_;
    SimdTarget simd_target_;
    Pose X_a_b_;
    HybridContactStatistics work_;
};

template <typename Queries>
std::unique_ptr<Engine> make_hybrid(const TriangleMesh& a, const TriangleMesh& b) {
    return std::make_unique<HybridEngine<Queries>>(a, b);
}

const std::map<std::string, std::unique_ptr<Engine> (*)(const TriangleMesh&, const TriangleMesh&)>
    kHybridEngines = {{"paper", make_hybrid<LibraryQueries>},
                      {"obb", make_hybrid<QueriesWith<BoxNodeTest>>},
                      {"sphere", make_hybrid<QueriesWith<SphereNodeTest>>},
                      {"mixed", make_hybrid<QueriesWith<MixedNodeTest>>}};
const std::map<std::string, SimdTarget> kBvh8Engines = {
    {"wide_sse42", SimdTarget::sse42}, {"wide_avx2", SimdTarget::avx2}, {"wide_avx512", SimdTarget::avx512}};

/// The names of our engines: the paper's tree with each node test (paper, obb, sphere, mixed) and the BVH8
/// with each SIMD target (wide_sse42, wide_avx2, wide_avx512).
bool is_our_engine(const std::string& name) {
    return kHybridEngines.contains(name) || kBvh8Engines.contains(name);
}

/// One of our engines. Both meshes must outlive it. Throws std::runtime_error if this machine lacks its SIMD
/// target.
std::unique_ptr<Engine> make_our_engine(const std::string& name, const TriangleMesh& a,
                                        const TriangleMesh& b) {
    if (const auto make = kHybridEngines.find(name); make != kHybridEngines.end()) {
        return make->second(a, b);
    }
    const SimdTarget simd_target = kBvh8Engines.at(name);
    if (!can_run(simd_target)) {
        throw std::runtime_error("this processor lacks the instruction set");
    }
    return std::make_unique<Bvh8Engine>(a, b, simd_target);
}

}  // namespace

PairEngines make_engines(const TriangleMesh& a, const TriangleMesh& b, std::span<const char* const> names) {
    PairEngines made;
    for (const std::string name : names) {
        const bool is_ours = is_our_engine(name);
        try {
            made.engines.push_back(
                {name, is_ours,
                 is_ours ? make_our_engine(name, a, b) : make_peer<MakeEngine>(name, kMakeEngine, a, b)});
        } catch (const std::exception& error) {
            made.absent.push_back(name + ": " + error.what());
        }
    }
    return made;
}

}  // namespace campuswalk::tools::bench
