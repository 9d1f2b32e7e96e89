#pragma once

#include <memory>
#include <optional>

#include "collision/ray.h"
#include "collision/triangle_mesh.h"

namespace campuswalk::bench {

/// A mesh in Bullet's bounding volume hierarchy (quantised, float32).
class BulletRays {
public:
    /// `mesh` must outlive it.
    explicit BulletRays(const collision::TriangleMesh& mesh);
    ~BulletRays();

    /// The fraction of the first hit.
    std::optional<double> first_on_ray(const collision::Ray& ray) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace campuswalk::bench
