#include "engine/simulation/contact_detector.h"

#include <algorithm>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/angles.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using collision::MoveTrace;
using collision::ObjectId;
using Eigen::Vector3d;
using support::radians;

/// A ContactDetector whose avatar the test moves.
class MovedDetector {
public:
    explicit MovedDetector(const scene::Campus& campus, std::uint32_t ignored_layers = 0,
                           Tick stay_ticks = 1000)
        : campus_(campus), detector_(campus, AvatarProfile{}, ignored_layers, stay_ticks) {}

    std::vector<std::string> move(const std::vector<Vector3d>& path,
                                  const std::vector<collision::Touch>& touching = {}) {
        MoveTrace trace;
        trace.path = path;
        trace.touching = touching;
        AvatarState avatar;
        avatar.position = path.back();
        avatar.yaw = yaw;
        detector_.detect(tick_++, avatar, trace, found);
        return lines();
    }
    std::vector<std::string> leave_all() {
        detector_.leave_all(tick_, found);
        return lines();
    }

    double yaw = 0.0;
    std::vector<DetectedTransition> found;

private:
    /// The transitions as "KIND OBJECT".
    std::vector<std::string> lines() const {
        constexpr const char* kDetectionModes[] = {"collision", "trigger", "ray"};
        constexpr const char* kPhases[] = {"exit", "enter", "stay"};
        std::vector<std::string> out;
        for (const DetectedTransition& s : found) {
            out.push_back(std::string(kDetectionModes[static_cast<int>(s.mode)]) + "." +
                          kPhases[static_cast<int>(s.transition.phase)] + " " +
                          campus_.objects[index_of(s.transition.object)].id);
        }
        return out;
    }

    const scene::Campus& campus_;
    ContactDetector detector_;
    Tick tick_ = 0;
};

using Lines = std::vector<std::string>;

scene::Campus campus_with(const std::string& name, const Vector3d& min, const Vector3d& max,
                          Detection detection) {
    scene::Campus campus = empty_campus();
    add_box(campus, name, min, max, {detection, "", true, ""});
    return campus;
}

TEST(ContactDetector, DetectsASolidByItsGap) {
    const scene::Campus campus = campus_with("wall", {0, 0, 0}, {1, 3, 1}, Detection::solid);
    const ObjectId wall{0};
    MovedDetector detector(campus);
    const Vector3d here(-5, 0, 0);
    EXPECT_EQ(detector.move({here}, {{wall, 0.0211}}), Lines());
    EXPECT_EQ(detector.move({here, here}, {{wall, 0.0209}}), Lines({"collision.enter wall"}));
    EXPECT_EQ(detector.move({here, here}, {{wall, 0.0249}}), Lines()) << "still within five millimetres";
    EXPECT_EQ(detector.move({here, here}, {{wall, 0.0251}}), Lines({"collision.exit wall"}));
    EXPECT_EQ(detector.move({here, here}, {{wall, 0.0249}}), Lines()) << "too far to begin a contact";
    EXPECT_EQ(detector.move({here, here}, {{wall, -0.1}}), Lines({"collision.enter wall"}));
    EXPECT_EQ(detector.move({here, here}), Lines({"collision.exit wall"})) << "out of reach";
}

TEST(ContactDetector, DetectsTheObjectThatTheAvatarLooksAt) {
    const scene::Campus campus = campus_with("sign", {-1, 0, -5}, {1, 3, -4}, Detection::ray);
    MovedDetector detector(campus);
    EXPECT_EQ(detector.move({{0, 0, 0}}), Lines({"ray.enter sign"}));
    EXPECT_NEAR(detector.found[0].distance, 4.0, 1e-12);
    detector.yaw = radians(90);
    EXPECT_EQ(detector.move({{0, 0, 0}, {0, 0, 0}}), Lines({"ray.exit sign"}));
    EXPECT_EQ(detector.move({{0, 0, 0}, {5, 0, -4.5}}), Lines({"ray.enter sign"}))
        << "to the left, from the side";
    EXPECT_NEAR(detector.found[0].distance, 4.0, 1e-12);
    detector.yaw = radians(-90);
    EXPECT_EQ(detector.move({{5, 0, -4.5}, {-5, 0, -4.5}}), Lines()) << "from the other side to the right";
}

TEST(ContactDetector, FindsWhenInATickATriggerIsEnteredAndLeft) {
    const scene::Campus campus = campus_with("door", {-1, 0, -3}, {1, 2, -2}, Detection::trigger);
    MovedDetector detector(campus);
    EXPECT_EQ(detector.move({{0, 0, 0}}), Lines());
    // Two segments at an angle: the second, from z = -1 to -2, touches the face at -1.7.
    EXPECT_EQ(detector.move({{0, 0, 0}, {0.5, 0, -1}, {0.5, 0, -2}}), Lines({"trigger.enter door"}));
    EXPECT_NEAR(detector.found[0].transition.at, (1 + 0.7) / 2, 1e-9);
    // Four segments: the second, from z = -3 to -4, leaves at -3.301.
    EXPECT_EQ(detector.move({{0.5, 0, -2}, {0, 0, -3}, {0, 0, -4}, {0, 0, -5}, {0, 0, -6}}),
              Lines({"trigger.exit door"}));
    EXPECT_NEAR(detector.found[0].transition.at, (1 + 0.301) / 4, 1e-9);
}

TEST(ContactDetector, KeepsAContactThatIsLeftAndReenteredWithinATick) {
    const scene::Campus campus = campus_with("door", {-1, 0, -3}, {1, 2, -2}, Detection::trigger);
    MovedDetector detector(campus);
    EXPECT_EQ(detector.move({{0, 0, -2.5}}), Lines({"trigger.enter door"}));
    EXPECT_EQ(detector.found[0].transition.at, 1.0) << "placed there";
    EXPECT_EQ(detector.move({{0, 0, -2.5}, {0, 0, 0}, {0, 0, -2.5}}), Lines());
    EXPECT_EQ(detector.move({{0, 0, -2.5}, {0, 0, 0}}), Lines({"trigger.exit door"}));
    EXPECT_EQ(detector.move({{0, 0, 0}, {0, 0, -2.5}, {0, 0, 0}}),
              Lines({"trigger.enter door", "trigger.exit door"}));
    EXPECT_NEAR(detector.found[0].transition.at, 0.5 * (1.7 / 2.5), 1e-9);
    EXPECT_NEAR(detector.found[1].transition.at, 0.5 + 0.5 * (0.8 / 2.5), 1e-9);
}

TEST(ContactDetector, ReportsTheDetectionModesOfAnObjectInAFixedOrder) {
    const scene::Campus campus =
        campus_with("all", {-1, 0, -1}, {1, 3, 1}, Detection::solid | Detection::trigger | Detection::ray);
    MovedDetector detector(campus);
    EXPECT_EQ(detector.move({{0, 0, 0}}, {{ObjectId{0}, 0.0}}),
              Lines({"collision.enter all", "trigger.enter all", "ray.enter all"}));
    EXPECT_EQ(detector.found[2].distance, 0.0) << "the eyes are inside";
    EXPECT_EQ(detector.leave_all(), Lines({"collision.exit all", "trigger.exit all", "ray.exit all"}));
    EXPECT_EQ(detector.leave_all(), Lines());
}

TEST(ContactDetector, OrdersExitsByObject) {
    scene::Campus campus = empty_campus();
    add_box(campus, "sign", {-1, 0, -5}, {1, 3, -4}, {Detection::ray, "", true, ""});
    add_box(campus, "zone", {-1, 0, -1}, {1, 3, 1}, {Detection::trigger, "", true, ""});
    add_box(campus, "wall", {2, 0, 0}, {3, 3, 1}, {Detection::solid, "", true, ""});
    MovedDetector detector(campus);
    EXPECT_EQ(detector.move({{0, 0, 0}}, {{ObjectId{2}, 0.0}}),
              Lines({"ray.enter sign", "trigger.enter zone", "collision.enter wall"}));
    EXPECT_EQ(detector.leave_all(), Lines({"ray.exit sign", "trigger.exit zone", "collision.exit wall"}));
}

TEST(ContactDetector, SkipsIgnoredLayers) {
    scene::Campus campus = empty_campus();
    add_box(campus, "sign", {-1, 0, -5}, {1, 3, -4}, {Detection::ray, "", true, "signs"});
    add_box(campus, "zone", {-1, 0, -1}, {1, 3, 1}, {Detection::trigger, "", true, "zones"});
    EXPECT_EQ(MovedDetector(campus, 1U << campus.layer_index("signs")).move({{0, 0, 0}}),
              Lines({"trigger.enter zone"}));
    EXPECT_EQ(MovedDetector(campus, 1U << campus.layer_index("zones")).move({{0, 0, 0}}),
              Lines({"ray.enter sign"}));
}

TEST(ContactDetector, PutsTransitionsInATotalOrder) {
    scene::Campus campus = empty_campus();
    support::Dice dice(5);
    for (int i = 0; i < 40; ++i) {
        const Vector3d low = dice.in_cube(8.0);
        const Vector3d size(dice.between(0.1, 3.0), dice.between(0.1, 3.0), dice.between(0.1, 3.0));
        const Detection detection = dice.chance(0.5)   ? Detection::trigger
                                    : dice.chance(0.5) ? Detection::ray
                                                       : Detection::trigger | Detection::ray;
        add_box(campus, "box-" + std::to_string(i), low, low + size, {detection, "", true, ""});
    }
    MovedDetector detector(campus, 0, 2);
    Vector3d foot(0, 0, 0);
    std::size_t several = 0;
    for (int i = 0; i < support::repeats(2000); ++i) {
        std::vector<Vector3d> path = {foot};
        for (int part = dice.below(4); part >= 0; --part) {
            path.push_back(0.9 * path.back() + dice.in_cube(2.0));
        }
        detector.yaw = dice.between(-std::numbers::pi, std::numbers::pi);
        detector.move(path);
        foot = path.back();
        const auto key = [](const DetectedTransition& s) {
            return std::tuple(s.transition.at, static_cast<int>(s.transition.phase),
                              index_of(s.transition.object), static_cast<int>(s.mode));
        };
        for (std::size_t j = 1; j < detector.found.size(); ++j) {
            ASSERT_LT(key(detector.found[j - 1]), key(detector.found[j])) << "move " << i;
            ++several;
        }
    }
    EXPECT_GT(several, 20U) << "moves with a single transition have no order to check";
}

}  // namespace
}  // namespace campuswalk::engine
