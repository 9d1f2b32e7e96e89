#include "engine/walkspace/stride/partial_world.h"

#include <utility>
#include <variant>
#include <vector>

#include "collision/mesh/mesh_collider.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::MeshCollider;
using collision::ObjectId;

namespace {

/// Holds only what overlaps a box.
class LocalBroadPhase final : public collision::BroadPhase {
public:
    explicit LocalBroadPhase(const Aabb& within) : within_(within) {}

    void insert(ObjectId id, const Aabb& box) override {
        if (box.overlaps(within_)) {
            all_.insert(id, box);
        }
    }
    void overlapping(const Aabb& box, std::vector<ObjectId>& out) const override {
        all_.overlapping(box, out);
    }
    void crossing(const collision::Vec3& from, const collision::Vec3& to,
                  std::vector<ObjectId>& out) const override {
        all_.crossing(from, to, out);
    }

private:
    Aabb within_;
    collision::LinearBroadPhase all_;
};

/// The triangles near the box, in their order, without those of the range.
collision::TriangleMesh cut(const collision::TriangleMesh& mesh, const collision::Pose& X_world_mesh,
                            const scene::TriangleRange& left_out, const Aabb& within) {
    collision::TriangleMesh rest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const collision::Triangle t = vertices(mesh, i);
        Aabb box;
        for (const collision::Vec3& vertex : {t.a, t.b, t.c}) {
            box.extend(X_world_mesh * vertex);
        }
        if (left_out.contains(i) || !box.overlaps(within)) {
            continue;
        }
        const auto first = static_cast<std::uint32_t>(rest.positions.size());
        for (const std::uint32_t vertex : mesh.triangles[i]) {
            rest.positions.push_back(mesh.positions[vertex]);
        }
        rest.triangles.push_back({first, first + 1, first + 2});
    }
    return rest;
}

}  // namespace

std::unique_ptr<collision::World> world_without(const collision::World& world, ObjectId object,
                                                const scene::TriangleRange& triangles, const Aabb& within) {
    auto partial = std::make_unique<collision::World>(std::make_unique<LocalBroadPhase>(within));
    for (std::size_t i = 0; i < world.size(); ++i) {
        const auto id = static_cast<ObjectId>(i);
        collision::Object copy = world.object(id);
        if (id == object) {
            const auto& mesh = std::get<std::shared_ptr<const MeshCollider>>(copy.shape);
            collision::TriangleMesh rest = cut(mesh->mesh(), copy.X_world_shape, triangles, within);
            if (rest.triangles.empty()) {
                return nullptr;
            }
            copy.shape = std::make_shared<const MeshCollider>(std::move(rest));
        }
        partial->add(std::move(copy));
    }
    return partial;
}

}  // namespace campuswalk::engine
