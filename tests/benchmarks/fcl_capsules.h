#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/shapes.h"
#include "collision/triangle_mesh.h"

namespace campuswalk::bench {

/// A mesh in FCL's hierarchy of oriented boxes and swept spheres, in double precision.
class FclCapsules {
public:
    explicit FclCapsules(const collision::TriangleMesh& mesh);
    ~FclCapsules();

    /// Replaces `out` by the triangles that an upright capsule touches, ascending.
    void triangles_near(const collision::Segment& upright, double radius,
                        std::vector<std::uint32_t>& out) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace campuswalk::bench
