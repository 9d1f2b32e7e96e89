#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/world.h"

namespace campuswalk::engine {

/// Calls `visit` for the vertices of each triangle of the world's meshes.
template <typename Visit>
void visit_triangles(const collision::World& world, const Visit& visit) {
    for (std::size_t i = 0; i < world.size(); ++i) {
        const collision::Object& object = world.object(static_cast<collision::ObjectId>(i));
        const auto* shape = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape);
        const std::size_t triangles = shape == nullptr ? 0 : (*shape)->mesh().triangles.size();
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const collision::Triangle own = collision::vertices((*shape)->mesh(), t);
            const collision::Pose& X = object.X_world_shape;
            visit(collision::Vec3(X * own.a), collision::Vec3(X * own.b), collision::Vec3(X * own.c));
        }
    }
}

/// How many triangles there are near a place: what a stride there costs. Each counts where its middle is, as
/// those that are many are small.
class TriangleDensity {
public:
    explicit TriangleDensity(const collision::World& world);

    /// Within 1 to 2 m of the foot, and of the body above it.
    double around(const collision::Vec3& foot) const;

private:
    using Cell = std::array<int, 3>;
    struct Count {
        Cell cell;
        std::uint32_t triangles = 0;
    };

    static Cell cell_at(const collision::Vec3& point);
    std::uint32_t count_in(const Cell& cell) const;

    std::vector<Count> counts_;  ///< by cell
};

}  // namespace campuswalk::engine
