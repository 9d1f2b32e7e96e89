#include "tools/campuswalk_bench/explore/solid_triangles.h"

#include <array>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "collision/geometry/trigonometry.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

constexpr int kFacets = 24;

/// A profile of (distance from the axis, height along it), turned about an axis.
using Outline = std::vector<std::pair<double, double>>;

class Gatherer {
public:
    explicit Gatherer(collision::TriangleMesh& mesh) : mesh_(mesh) {}

    void add(const collision::Object& object) {
        pose_ = &object.X_world_shape;
        std::visit([this](const auto& shape) { add(shape); }, object.shape);
    }

private:
    void add(const std::shared_ptr<const collision::MeshCollider>& collider) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (const Eigen::Vector3f& p : collider->mesh().positions) {
            vertex(p.cast<double>());
        }
        for (const auto& t : collider->mesh().triangles) {
            mesh_.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }

    void add(const collision::Box& box) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (std::uint32_t i = 0; i < 8; ++i) {
            const Vec3 side((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
            vertex(side.cwiseProduct(box.half_extents));
        }
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
            {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
        for (const auto& face : kFaces) {
            mesh_.triangles.push_back({first + face[0], first + face[1], first + face[2]});
            mesh_.triangles.push_back({first + face[0], first + face[2], first + face[3]});
        }
    }

    void add(const collision::Sphere& sphere) { add(collision::Capsule{sphere.radius, 0.0}); }

    void add(const collision::Capsule& capsule) {
        Outline outline;
        const auto add_cap = [&](int first, int last, double middle) {
            for (int i = first; i <= last; ++i) {
                const auto angle = collision::sin_cos(2.0 * std::numbers::pi * i / kFacets);
                outline.emplace_back(capsule.radius * angle.sin, middle - capsule.radius * angle.cos);
            }
        };
        add_cap(0, kFacets / 4, -capsule.half_length);
        add_cap(kFacets / 4, kFacets / 2, capsule.half_length);
        turn(outline, [](double x, double along, double z) { return Vec3(x, along, z); });
    }

    void add(const collision::Wheel& wheel) {
        const double half = wheel.half_width;
        turn({{0, -half}, {wheel.radius, -half}, {wheel.radius, half}, {0, half}},
             [](double x, double along, double z) { return Vec3(along, z, x); });
    }

    /// The outline starts and ends on the axis; its lower end comes first.
    template <typename Place>
    void turn(const Outline& outline, const Place& place) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto count = static_cast<std::uint32_t>(outline.size());
        for (int i = 0; i < kFacets; ++i) {
            const auto angle = collision::sin_cos(2.0 * std::numbers::pi * i / kFacets);
            for (const auto& [radius, along] : outline) {
                vertex(place(radius * angle.sin, along, radius * angle.cos));
            }
        }
        for (std::uint32_t i = 0; i < kFacets; ++i) {
            const std::uint32_t here = first + count * i;
            const std::uint32_t next = first + count * ((i + 1) % kFacets);
            for (std::uint32_t k = 0; k + 1 < count; ++k) {
                mesh_.triangles.push_back({here + k, next + k, next + k + 1});
                mesh_.triangles.push_back({here + k, next + k + 1, here + k + 1});
            }
        }
    }

    void vertex(const Vec3& p) { mesh_.positions.push_back((*pose_ * p).cast<float>()); }

    collision::TriangleMesh& mesh_;
    const collision::Pose* pose_ = nullptr;
};

}  // namespace

collision::TriangleMesh solid_triangles(const collision::World& world) {
    collision::TriangleMesh mesh;
    Gatherer gatherer(mesh);
    for (std::size_t i = 0; i < world.size(); ++i) {
        const collision::Object& object = world.object(static_cast<collision::ObjectId>(i));
        if (any_of(object.detection, collision::Detection::solid)) {
            gatherer.add(object);
        }
    }
    return mesh;
}

}  // namespace campuswalk::tools::bench
