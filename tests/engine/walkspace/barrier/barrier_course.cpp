#include "tests/engine/walkspace/barrier/barrier_course.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "collision/mesh/mesh_collider.h"
#include "tests/support/dice.h"

namespace campuswalk::engine {

using collision::Object;
using collision::ObjectId;
using collision::Pose;
using collision::Vec3;

namespace {

constexpr double kHalfWidth = 1.5;
constexpr double kHalfLength = 4.0;
constexpr double kHigh = 4.0;

/// Places boxes and prisms in the corridor's own frame: x along it, y up.
class Corridor {
public:
    explicit Corridor(support::Dice& dice)
        : world_(std::make_unique<collision::World>(std::make_unique<collision::LinearBroadPhase>())) {
        const double yaw = dice.between(0.0, 2.0 * std::numbers::pi);
        X_.rotation << std::cos(yaw), 0, std::sin(yaw), 0, 1, 0, -std::sin(yaw), 0, std::cos(yaw);
        X_.translation = Vec3(dice.between(-20.0, 20.0), dice.between(-2.0, 2.0), dice.between(-20.0, 20.0));
        box({-kHalfLength - 1, -0.5, -kHalfWidth - 1}, {kHalfLength + 1, 0, kHalfWidth + 1});
        for (const double side : {-1.0, 1.0}) {
            const double z = side * (kHalfWidth + 0.2);
            box({-kHalfLength, -0.2, z - 0.2}, {kHalfLength, kHigh + 4, z + 0.2});
            const double x = side * (kHalfLength + 0.2);
            box({x - 0.2, -0.2, -kHalfWidth - 0.4}, {x + 0.2, kHigh + 4, kHalfWidth + 0.4});
        }
    }

    ObjectId box(const Vec3& min, const Vec3& max) {
        const Pose pose{X_.rotation, X_ * Vec3(0.5 * (min + max))};
        return world_->add({collision::Box{0.5 * (max - min)}, pose});
    }
    /// A ramp from x = 0 upwards, and a platform behind it.
    ObjectId ramp(double angle, double height) {
        const double foot = height / std::tan(angle);
        collision::TriangleMesh mesh;
        for (const auto& [x, y] : {std::pair(-0.0, -0.1), std::pair(0.0, 0.0), std::pair(foot, height),
                                   std::pair(kHalfLength, height), std::pair(kHalfLength, -0.1)}) {
            for (const double z : {-kHalfWidth, kHalfWidth}) {
                mesh.positions.push_back(Vec3(x, y, z).cast<float>());
            }
        }
        for (std::uint32_t i = 2; i + 3 < mesh.positions.size(); i += 2) {
            mesh.triangles.push_back({i, i + 1, i + 2});
            mesh.triangles.push_back({i + 1, i + 3, i + 2});
        }
        return world_->add({std::make_shared<const collision::MeshCollider>(std::move(mesh)), X_});
    }
    Vec3 at(double x, double y) const { return X_ * Vec3(x, y, 0); }

    BarrierCase finished(std::string name, ReasonKind kind, double measured, double goal_height) {
        return {
            std::move(name), std::move(world_), at(-2.5, 0.0), at(3.0, goal_height), kind, measured, {}, {}};
    }

private:
    std::unique_ptr<collision::World> world_;
    Pose X_;
};

BarrierCase riser(support::Dice& dice, double height) {
    Corridor corridor(dice);
    const ObjectId platform = corridor.box({0, -0.1, -kHalfWidth}, {kHalfLength, height, kHalfWidth});
    BarrierCase built =
        corridor.finished(height > kHighestRiser ? "ledge" : "riser",
                          height > kHighestRiser ? ReasonKind::ledge : ReasonKind::riser, height, height);
    built.object = platform;
    return built;
}

BarrierCase slope(support::Dice& dice, double angle) {
    Corridor corridor(dice);
    const ObjectId ramp = corridor.ramp(angle, 1.2);
    BarrierCase built = corridor.finished("slope", ReasonKind::slope, angle, 1.2);
    built.object = ramp;
    return built;
}

/// One object on both sides, so that taking it away would also open the way: it is part of the floor.
BarrierCase opening(support::Dice& dice, double width) {
    Corridor corridor(dice);
    const double z = dice.between(-0.8, 0.8);
    corridor.box({-0.1, -0.1, -kHalfWidth - 0.1}, {0.1, kHigh, z - 0.5 * width});
    corridor.box({-0.1, -0.1, z + 0.5 * width}, {0.1, kHigh, kHalfWidth + 0.1});
    return corridor.finished("opening", ReasonKind::opening, width, 0.0);
}

BarrierCase headroom(support::Dice& dice, double height) {
    Corridor corridor(dice);
    const double depth = dice.between(0.1, 1.5);
    const ObjectId lintel =
        corridor.box({-depth, height, -kHalfWidth - 0.1}, {depth, kHigh + 3, kHalfWidth + 0.1});
    BarrierCase built = corridor.finished("headroom", ReasonKind::headroom, height, 0.0);
    built.object = lintel;
    return built;
}

/// A gateway of 1.2 m, closed by a leaf but for `beside`.
BarrierCase gate(support::Dice& dice, double beside) {
    Corridor corridor(dice);
    corridor.box({-0.1, -0.1, -kHalfWidth - 0.1}, {0.1, kHigh, -0.6});
    corridor.box({-0.1, -0.1, 0.6}, {0.1, kHigh, kHalfWidth + 0.1});
    const ObjectId leaf = corridor.box({-0.03, 0.0, -0.6}, {0.03, 2.2, 0.6 - beside});
    BarrierCase built = corridor.finished("gate", ReasonKind::object, 0.0, 0.0);
    built.object = leaf;
    if (beside > 0.0) {
        built.opening = beside;
    }
    return built;
}

}  // namespace

std::vector<BarrierCase> barrier_course() {
    constexpr double kDegree = std::numbers::pi / 180.0;
    constexpr int kEach = 33;
    support::Dice dice(22);
    std::vector<BarrierCase> cases;
    for (int i = 0; i < kEach; ++i) {
        cases.push_back(riser(dice, dice.between(0.305, 0.595)));
        cases.push_back(riser(dice, dice.between(0.61, 2.8)));
        cases.push_back(slope(dice, dice.between(50.3 * kDegree, 74.0 * kDegree)));
        cases.push_back(opening(dice, dice.between(0.4, 0.595)));
        cases.push_back(headroom(dice, dice.between(0.9, 1.79)));
        cases.push_back(gate(dice, i % 2 == 0 ? 0.0 : dice.between(0.35, 0.58)));
    }
    cases.push_back(riser(dice, 0.45));
    cases.push_back(gate(dice, 0.55));
    return cases;
}

}  // namespace campuswalk::engine
