#pragma once

#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// A mesh in FCL's types.
class FclMesh {
public:
    explicit FclMesh(const collision::TriangleMesh& mesh) {
        for (const Eigen::Vector3f& position : mesh.positions) {
            positions_.emplace_back(position.cast<double>());
        }
        for (const auto& t : mesh.triangles) {
            triangles_.emplace_back(t[0], t[1], t[2]);
        }
    }

    template <typename Volume>
    void build(fcl::BVHModel<Volume>& model) const {
        model.beginModel(static_cast<int>(triangles_.size()), static_cast<int>(positions_.size()));
        model.addSubModel(positions_, triangles_);
        model.endModel();
    }

private:
    std::vector<fcl::Vector3d> positions_;
    std::vector<fcl::Triangle> triangles_;
};

}  // namespace campuswalk::tools::bench
