// CGAL's tree of axis-aligned boxes with exact predicates: one mesh is in the tree, and each moved triangle
// of the other is a query. The only exact peer.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iterator>

#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

namespace {

using collision::Pose;
using collision::TriangleMesh;
using collision::TrianglePair;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Triangles placed(const TriangleMesh& mesh, const Pose& X) {
    const auto vertex = [&](std::uint32_t k) {
        const collision::Vec3 p = b_vertex_in_a(X, mesh.positions[k]);
        return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    Triangles triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        triangles.emplace_back(vertex(t[0]), vertex(t[1]), vertex(t[2]));
    }
    return triangles;
}

class Cgal final : public Engine {
public:
    Cgal(const TriangleMesh& a, const TriangleMesh& b)
        : mesh_b_(b), a_(placed(a, {})), tree_(a_.cbegin(), a_.cend()) {
        tree_.build();
    }

    void set_pose(const Pose& X_a_b) override { b_ = placed(mesh_b_, X_a_b); }

    void all_pairs(std::vector<TrianglePair>& out) override {
        out.clear();
        for (std::size_t i = 0; i < b_.size(); ++i) {
            hits_.clear();
            tree_.all_intersected_primitives(b_[i], std::back_inserter(hits_));
            for (const Triangles::const_iterator& triangle : hits_) {
                out.push_back(pair(triangle, i));
            }
        }
    }

    std::optional<TrianglePair> first_pair() override {
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (const auto hit = tree_.any_intersected_primitive(b_[i])) {
                return pair(*hit, i);
            }
        }
        return std::nullopt;
    }

private:
    TrianglePair pair(Triangles::const_iterator a, std::size_t b) const {
        return {static_cast<std::uint32_t>(a - a_.cbegin()), static_cast<std::uint32_t>(b)};
    }

    const TriangleMesh& mesh_b_;
    Triangles a_;
    Triangles b_;
    Tree tree_;
    std::vector<Triangles::const_iterator> hits_;
};

}  // namespace

extern "C" Engine* campuswalk_make_engine(const TriangleMesh& a, const TriangleMesh& b) {
    return new Cgal(a, b);
}

}  // namespace campuswalk::tools::bench
