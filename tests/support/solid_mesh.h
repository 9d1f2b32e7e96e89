#pragma once

#include <stdexcept>

#include "collision/mesh/mesh_query.h"

namespace campuswalk::support {

/// A mesh with an inside test, by both trees, which must agree.
class SolidMesh {
public:
    explicit SolidMesh(const collision::TriangleMesh& mesh)
        : bvh8_(mesh, collision::TreeKind::bvh8), hybrid_(mesh, collision::TreeKind::hybrid) {}

    bool contains(const collision::Vec3& point) const {
        const bool inside = collision::is_inside(bvh8_, point);
        if (collision::is_inside(hybrid_, point) != inside) {
            throw std::logic_error("the trees disagree about what is inside");
        }
        return inside;
    }

private:
    collision::MeshCollider bvh8_;
    collision::MeshCollider hybrid_;
};

}  // namespace campuswalk::support
