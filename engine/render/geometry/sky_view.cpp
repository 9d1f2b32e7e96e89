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
constexpr double kReach = 25.0;                     // metres: higher than any hall's ceiling
constexpr double kGoldenAngle = 2.399963229728653;  // spreads points of a spiral evenly

// Even over the disc below the sky's half sphere, so that every ray stands for as much light on level ground.
Vector3d direction(std::size_t i) {
    const double radius = std::sqrt((static_cast<double>(i) + 0.5) / kRays);
    const double turn = kGoldenAngle * static_cast<double>(i);
    return {radius * std::cos(turn), std::sqrt(1.0 - radius * radius), radius * std::sin(turn)};
}

bool crosses(const Eigen::AlignedBox3d& box, const Vector3d& from, const Vector3d& way) {
    double enter = 0.0;
    double leave = kReach;
    for (int i = 0; i < 3; ++i) {
        if (way[i] == 0.0) {
            if (from[i] < box.min()[i] || from[i] > box.max()[i]) {
                return false;
            }
            continue;
        }
        const double a = (box.min()[i] - from[i]) / way[i];
        const double b = (box.max()[i] - from[i]) / way[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

bool hits(const std::array<Vector3d, 3>& corners, const Vector3d& from, const Vector3d& way) {
    const std::optional<double> distance = scene::line_through_triangle(corners, from, way);
    return distance && *distance > 0.0 && *distance < kReach;
}

bool hits_in_place(const CampusGeometry& geometry, const Batch& batch, const Vector3d& from,
                   const Vector3d& way) {
    for (std::size_t i = batch.first; i < batch.first + batch.count; i += 3) {
        std::array<Vector3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] =
                Eigen::Vector3f(geometry.vertices[geometry.indices[i + k]].position.data()).cast<double>();
        }
        if (hits(corners, from, way)) {
            return true;
        }
    }
    return false;
}

// Each instance by the ray as it looks from there, whose lengths count as before.
bool hits(const CampusGeometry& geometry, const Batch& batch, const Vector3d& from, const Vector3d& way) {
    for (std::size_t i = 0; i < batch.instances; ++i) {
        const Eigen::Affine3d back = placement_of(geometry.instances[batch.first_instance + i]).inverse();
        if (hits_in_place(geometry, batch, back * from, back.linear() * way)) {
            return true;
        }
    }
    return false;
}

}  // namespace

double open_sky(const CampusGeometry& geometry, const Vector3d& eye) {
    std::vector<const Batch*> covers;
    for (const Batch& batch : geometry.batches) {
        const bool solid = geometry.materials[batch.material].material.alpha_mode == scene::AlphaMode::opaque;
        if (solid && batch.bounds.max().y() > eye.y() &&
            batch.bounds.squaredExteriorDistance(eye) < kReach * kReach) {
            covers.push_back(&batch);
        }
    }
    std::size_t open = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
        const Vector3d way = direction(i);
        bool covered = false;
        for (const Batch* batch : covers) {
            if (crosses(batch->bounds, eye, way) && hits(geometry, *batch, eye, way)) {
                covered = true;
                break;
            }
        }
        open += covered ? 0U : 1U;
    }
    return static_cast<double>(open) / kRays;
}

}  // namespace campuswalk::engine::render
