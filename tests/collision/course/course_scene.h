#pragma once

#include <memory>

#include "collision/world/world.h"
#include "tests/collision/mover/audited_body.h"
#include "tests/support/mesh_pieces.h"

/// What the tests of the conformance course share. Its scenes are in tests/support/course.
namespace campuswalk::collision::course {

/// Of the default body, metres.
constexpr double kRadius = 0.3;
constexpr double kHeight = 1.8;
constexpr double kSkin = 0.02;
/// Of a person, metres per second.
constexpr double kPace = 1.4;
const Vec3 kEast(kPace, 0, 0);

/// A horizontal unit vector, `degrees` from east towards -Z.
Vec3 towards(double degrees);

std::unique_ptr<World> empty_world();
/// A floor of 40 m by 40 m at height 0.
std::unique_ptr<World> floor_world();
/// The same with one more mesh, which `add` fills.
template <typename Add>
std::unique_ptr<World> floor_and(const Add& add) {
    auto world = floor_world();
    TriangleMesh mesh;
    add(mesh);
    support::add_object(*world, std::move(mesh));
    return world;
}

/// How far the body strays from where it is while it walks on at `velocity` for `seconds`, metres.
double jitter(AuditedBody& body, const Vec3& velocity, double seconds);

/// Walks straight to `goal` and stops there: true once within 5 cm of it, horizontally; false after
/// `seconds`.
bool reach(AuditedBody& body, const Vec3& goal, double speed, double seconds);

}  // namespace campuswalk::collision::course
