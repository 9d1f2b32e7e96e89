#include "engine/render/geometry/sky_view.h"

#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "scene/model/line_triangle.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kRays = 64;
constexpr double kReach = 25.0;                     // metres, higher than any ceiling
constexpr double kGoldenAngle = 2.399963229728653;  // radians, distributes points evenly on a spiral

// Cosine-weighted over the hemisphere: every ray carries the same irradiance onto level ground.
Vector3d ray_direction(std::size_t i) {
    const double radius = std::sqrt((static_cast<double>(i) + 0.5) / kRays);
    const double turn = kGoldenAngle * static_cast<double>(i);
    return {radius * std::cos(turn), std::sqrt(1.0 - radius * radius), radius * std::sin(turn)};
}

bool ray_overlaps(const Eigen::AlignedBox3d& box, const Vector3d& from, const Vector3d& direction) {
    double enter = 0.0;
    double leave = kReach;
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0.0) {
            if (from[i] < box.min()[i] || from[i] > box.max()[i]) {
                return false;
            }
            continue;
        }
        const double a = (box.min()[i] - from[i]) / direction[i];
        const double b = (box.max()[i] - from[i]) / direction[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

bool hits(const std::array<Vector3d, 3>& vertices, const Vector3d& from, const Vector3d& direction) {
    const std::optional<double> distance = scene::line_through_triangle(vertices, from, direction);
    return distance && *distance > 0.0 && *distance < kReach;
}

bool hits_baked(const CampusGeometry& geometry, const Batch& batch, const Vector3d& from,
                const Vector3d& direction) {
    for (std::size_t i = batch.first; i < batch.first + batch.count; i += 3) {
        std::array<Vector3d, 3> vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            vertices[k] =
                Eigen::Vector3f(geometry.vertices[geometry.indices[i + k]].position.data()).cast<double>();
        }
        if (hits(vertices, from, direction)) {
            return true;
        }
    }
    return false;
}

// Transforms the ray into each instance's frame; distances along it stay in units of `direction`.
bool hits(const CampusGeometry& geometry, const Batch& batch, const Vector3d& from,
          const Vector3d& direction) {
    for (std::size_t i = 0; i < batch.instances; ++i) {
        const Eigen::Affine3d X_first_instance =
            placement_of(geometry.instances[batch.first_instance + i]).inverse();
        if (hits_baked(geometry, batch, X_first_instance * from, X_first_instance.linear() * direction)) {
            return true;
        }
    }
    return false;
}

}  // namespace

double sky_view_factor(const CampusGeometry& geometry, const Vector3d& eye) {
    std::vector<const Batch*> occluders;
    for (const Batch& batch : geometry.batches) {
        const bool solid = geometry.materials[batch.material].material.alpha_mode == scene::AlphaMode::opaque;
        if (solid && batch.bounds.max().y() > eye.y() &&
            batch.bounds.squaredExteriorDistance(eye) < kReach * kReach) {
            occluders.push_back(&batch);
        }
    }
    std::size_t open = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
        const Vector3d direction = ray_direction(i);
        bool occluded = false;
        for (const Batch* batch : occluders) {
            if (ray_overlaps(batch->bounds, eye, direction) && hits(geometry, *batch, eye, direction)) {
                occluded = true;
                break;
            }
        }
        open += occluded ? 0U : 1U;
    }
    return static_cast<double>(open) / kRays;
}

}  // namespace campuswalk::engine::render
