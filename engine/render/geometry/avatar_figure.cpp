#include "engine/render/geometry/avatar_figure.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector3d;
using Color = std::array<std::uint8_t, 4>;

constexpr int kSides = 20;
constexpr int kRings = 7;  // per cap

// Linear colours; the jacket contrasts with grass, brick and asphalt.
constexpr Color kJacket = {176, 36, 20, 255};
constexpr Color kTrousers = {12, 17, 32, 255};
constexpr Color kShoes = {70, 66, 60, 255};
constexpr Color kSkin = {176, 108, 74, 255};
constexpr Color kHair = {20, 11, 6, 255};
constexpr Color kRucksack = {16, 58, 66, 255};

// Builds a body of height 1: z backwards (the figure faces -z), x to its right.
class FigureBuilder {
public:
    FigureBuilder(const Eigen::Matrix3d& rotation, double scale, const Vector3d& foot)
        : rotation_(rotation), scale_(scale), foot_(foot) {}

    // A tapered capsule from a to b with radii `radius_a` and `radius_b`; `flatten` scales it front to back.
    void limb(const Vector3d& a, const Vector3d& b, double radius_a, double radius_b, const Color& color,
              double flatten = 1.0) {
        const Vector3d axis = (b - a).normalized();
        const Vector3d side = axis.cross(Vector3d::UnitZ()).norm() > 0.1
                                  ? axis.cross(Vector3d::UnitZ()).normalized()
                                  : Vector3d::UnitX();
        const Vector3d front = side.cross(axis);
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (int ring = 0; ring < 2 * kRings; ++ring) {
            const bool far_cap = ring >= kRings;
            const double polar =
                0.5 * std::numbers::pi * (far_cap ? ring - kRings : ring - (kRings - 1)) / (kRings - 1);
            const double radius = far_cap ? radius_b : radius_a;
            const Vector3d centre = (far_cap ? b : a) + std::sin(polar) * radius * axis;
            for (int i = 0; i <= kSides; ++i) {
                const double turn = 2.0 * std::numbers::pi * i / kSides;
                const Vector3d out = std::cos(turn) * side + flatten * std::sin(turn) * front;
                const Vector3d normal =
                    std::cos(polar) * (std::cos(turn) * side + std::sin(turn) / flatten * front) +
                    std::sin(polar) * axis;
                vertex(centre + std::cos(polar) * radius * out, normal, color);
            }
        }
        for (std::uint32_t ring = 0; ring + 1 < 2 * kRings; ++ring) {
            for (std::uint32_t i = 0; i < kSides; ++i) {
                const std::uint32_t v = first + ring * (kSides + 1) + i;
                const std::uint32_t w = v + kSides + 1;
                mesh_.indices.insert(mesh_.indices.end(), {v, w, v + 1, v + 1, w, w + 1});
            }
        }
    }

    void ball(const Vector3d& centre, double radius, const Color& color) {
        limb(centre, centre + Vector3d(0, 1e-6, 0), radius, radius, color);
    }

    FigureMesh take() { return std::move(mesh_); }

private:
    void vertex(const Vector3d& p, const Vector3d& normal, const Color& color) {
        mesh_.vertices.push_back(make_vertex(foot_ + scale_ * (rotation_ * p),
                                             (rotation_ * normal).normalized(), Eigen::Vector2f(0, 0),
                                             color));
    }

    Eigen::Matrix3d rotation_;
    double scale_;
    Vector3d foot_;
    FigureMesh mesh_;
};

// `swing` is the forward angle of the thigh; the knee bends backwards.
void leg(FigureBuilder& figure, double x, double swing) {
    const Vector3d hip(x, 0.50, 0);
    const double shin = swing - (swing < 0.0 ? 0.5 : 0.15) * std::abs(swing);
    const Vector3d knee = hip + 0.235 * Vector3d(0, -std::cos(swing), -std::sin(swing));
    const Vector3d ankle = knee + 0.225 * Vector3d(0, -std::cos(shin), -std::sin(shin));
    figure.limb(hip, knee, 0.052, 0.040, kTrousers);
    figure.limb(knee, ankle, 0.040, 0.030, kTrousers);
    figure.limb(ankle + Vector3d(0, -0.012, 0.012), ankle + Vector3d(0, -0.016, -0.065), 0.026, 0.022,
                kShoes);
}

void arm(FigureBuilder& figure, double x, double swing) {
    const double side = x < 0.0 ? -1.0 : 1.0;
    const Vector3d shoulder(x, 0.788, 0);
    const double fore = swing + 0.25;
    const Vector3d elbow = shoulder + 0.165 * Vector3d(side * 0.07, -std::cos(swing), -std::sin(swing));
    const Vector3d wrist = elbow + 0.135 * Vector3d(side * 0.02, -std::cos(fore), -std::sin(fore));
    figure.limb(shoulder, elbow, 0.036, 0.029, kJacket);
    figure.limb(elbow, wrist, 0.029, 0.023, kJacket);
    figure.ball(wrist + 0.03 * Vector3d(0, -std::cos(fore), -std::sin(fore)), 0.024, kSkin);
}

}  // namespace

FigureMesh make_figure(const AvatarState& avatar, const AvatarProfile& profile, double stride,
                       const Vector3d& origin) {
    const Eigen::Matrix3d facing = Eigen::AngleAxisd(avatar.yaw, Vector3d::UnitY()).toRotationMatrix();
    FigureBuilder figure(facing, avatar.stature * profile.height, avatar.position - origin);
    const double swing = 0.42 * std::sin(stride);
    leg(figure, -0.052, swing);
    leg(figure, 0.052, -swing);
    arm(figure, -0.128, -0.8 * swing);
    arm(figure, 0.128, 0.8 * swing);
    figure.limb({-0.032, 0.515, 0}, {0.032, 0.515, 0}, 0.066, 0.066, kTrousers, 0.86);  // hips
    figure.limb({0, 0.575, 0}, {0, 0.75, 0}, 0.088, 0.100, kJacket, 0.72);              // trunk
    figure.limb({-0.108, 0.792, 0}, {0.108, 0.792, 0}, 0.040, 0.040, kJacket, 0.95);    // shoulders
    figure.limb({0, 0.60, 0.105}, {0, 0.745, 0.105}, 0.074, 0.066, kRucksack, 0.62);    // rucksack
    figure.limb({0, 0.82, 0.0}, {0, 0.87, -0.006}, 0.034, 0.032, kSkin);                // neck
    figure.limb({0, 0.905, -0.010}, {0, 0.930, -0.008}, 0.056, 0.062, kSkin);           // head
    figure.limb({0, 0.898, 0.017}, {0, 0.936, 0.008}, 0.052, 0.064, kHair);             // hair
    return figure.take();
}

}  // namespace campuswalk::engine::render
