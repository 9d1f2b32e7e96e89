#include "collision/world/bounds.h"

#include "collision/mesh/mesh_collider.h"
#include "collision/mesh/mesh_extent.h"

namespace campuswalk::collision {

namespace {

Aabb about(const Vec3& center, const Vec3& half) {
    return {center - half, center + half};
}

Aabb box_of(const std::shared_ptr<const MeshCollider>& mesh, const Pose& X) {
    if (X.rotation == Mat3::Identity()) {  // rounds as below: translating preserves the order
        const Aabb box = box_of(mesh->mesh().positions);
        return {box.min + X.translation, box.max + X.translation};
    }
    Aabb box;
    for (const auto& p : mesh->mesh().positions) {
        box.extend(X * p.cast<double>());
    }
    return box;
}

Aabb box_of(const Box& box, const Pose& X) {
    return about(X.translation, X.rotation.cwiseAbs() * box.half_extents);
}

Aabb box_of(const Sphere& sphere, const Pose& X) {
    return about(X.translation, Vec3::Constant(sphere.radius));
}

Aabb box_of(const Capsule& capsule, const Pose& X) {
    return about(X.translation,
                 (X.rotation.col(1).cwiseAbs() * capsule.half_length).array() + capsule.radius);
}

Aabb box_of(const Wheel& wheel, const Pose& X) {
    // A disc with normal n reaches radius * sqrt(1 - n_i^2) along axis i.
    const Vec3 n = X.rotation.col(0);
    const Vec3 rim = (1.0 - n.array().square()).max(0.0).sqrt() * wheel.radius;
    return about(X.translation, n.cwiseAbs() * wheel.half_width + rim);
}

}  // namespace

Aabb bounds_of(const Shape& shape, const Pose& X_world_shape) {
    const Aabb box = std::visit([&](const auto& s) { return box_of(s, X_world_shape); }, shape);
    const double size = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
    return box.grown(1e-12 * (1.0 + size));
}

}  // namespace campuswalk::collision
