#pragma once

#include <stdexcept>

#include "collision/mesh/mesh_query.h"

namespace campuswalk::support {

/// A mesh with an inside test, by both trees, which must agree.
class SolidMesh {
public:
    explicit SolidMesh(const collision::TriangleMesh& mesh)
        : wide_(mesh, collision::TreeKind::bvh8), paper_(mesh, collision::TreeKind::hybrid) {}

    bool contains(const collision::Vec3& point) const {
        const bool inside = collision::is_inside(wide_, point);
        if (collision::is_inside(paper_, point) != inside) {
            throw std::logic_error("the trees disagree about what is inside");
        }
        return inside;
    }

private:
    collision::MeshCollider wide_;
    collision::MeshCollider paper_;
};

}  // namespace campuswalk::support
