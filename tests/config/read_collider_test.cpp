#include "config/loader/campus/read_collider.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using scene::ColliderDescription;
using support::says;
using testing::ElementsAre;

class ReadCollider : public testing::Test {
protected:
    ColliderDescription read(const std::string& text) {
        EXPECT_THAT(folder_.about_collider(text), ElementsAre());
        return folder_.campus().colliders.at(0);
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadCollider, ReadsKeysThatAllShapesShare) {
    const ColliderDescription wall = read(
        "{id: hut/wall-2, building: hut, nodes: [wall, 'wall_*'], each: true, shape: mesh, mode: [solid, "
        "ray], "
        "layer: trees, popup: false}");
    EXPECT_EQ(wall.id, "hut/wall-2");
    EXPECT_EQ(wall.building, "hut");
    ASSERT_EQ(wall.nodes.size(), 2U);
    EXPECT_EQ(wall.nodes[1].pattern, "wall_*");
    EXPECT_TRUE(wall.each);
    EXPECT_TRUE(wall.modes.solid);
    EXPECT_FALSE(wall.modes.trigger);
    EXPECT_TRUE(wall.modes.ray);
    EXPECT_EQ(wall.layer, "trees");
    EXPECT_FALSE(wall.popup);
    EXPECT_TRUE(std::holds_alternative<scene::MeshShape>(wall.shape));
    EXPECT_EQ(wall.mark.line, 5);
    EXPECT_EQ(wall.mark.column, 5);
}

TEST_F(ReadCollider, OpensThePopUpOfItsBuildingByDefault) {
    EXPECT_TRUE(read("{id: a, building: hut, shape: mesh, mode: solid}").popup);
    const ColliderDescription plain = read("{id: a, nodes: wall, shape: mesh, mode: trigger}");
    EXPECT_FALSE(plain.popup);
    EXPECT_FALSE(plain.each);
    EXPECT_EQ(plain.layer, "");
    EXPECT_TRUE(plain.modes.trigger);
}

TEST_F(ReadCollider, ReadsBoxes) {
    const auto collider =
        read("{id: a, shape: box, center: [1, 2, 3], size: [4, 5, 6], yaw_deg: 45, mode: trigger}");
    const auto& box = std::get<scene::BoxShape>(collider.shape);
    EXPECT_EQ(box.center, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(box.size, Eigen::Vector3d(4, 5, 6));
    EXPECT_NEAR(box.yaw, std::numbers::pi / 4, 1e-15);
    const auto fitted = read("{id: a, shape: box, nodes: bench, mode: solid}");
    EXPECT_FALSE(std::get<scene::BoxShape>(fitted.shape).size);
}

TEST_F(ReadCollider, ReadsSpheresCapsulesAndWheels) {
    const auto sphere = read("{id: a, shape: sphere, center: [1, 2, 3], radius: 0.5, mode: ray}");
    EXPECT_EQ(std::get<scene::SphereShape>(sphere.shape).center, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(std::get<scene::SphereShape>(sphere.shape).radius, 0.5);

    const auto capsule = read("{id: a, shape: capsule, base: [1, 2, 3], radius: 0.5, height: 1, mode: ray}");
    EXPECT_EQ(std::get<scene::CapsuleShape>(capsule.shape).base, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(std::get<scene::CapsuleShape>(capsule.shape).radius, 0.5);
    EXPECT_EQ(std::get<scene::CapsuleShape>(capsule.shape).height, 1.0);

    const auto wheel =
        read("{id: a, shape: wheel, center: [1, 2, 3], radius: 2, width: 0.6, axis: z, mode: solid}");
    EXPECT_EQ(std::get<scene::WheelShape>(wheel.shape).center, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(std::get<scene::WheelShape>(wheel.shape).radius, 2.0);
    EXPECT_EQ(std::get<scene::WheelShape>(wheel.shape).width, 0.6);
    EXPECT_EQ(std::get<scene::WheelShape>(wheel.shape).axis, Eigen::Vector3d::UnitZ());
    const auto tilted = read("{id: a, shape: wheel, nodes: w, axis: [0, 3, 4], mode: solid}");
    EXPECT_TRUE(std::get<scene::WheelShape>(tilted.shape).axis.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
}

TEST_F(ReadCollider, DiagnosesMissingAndUnknownKeys) {
    EXPECT_THAT(folder_.about_collider("{}"),
                ElementsAre(says("a.campus.yaml:5:5: error missing-key", {"'id'"}),
                            says("a.campus.yaml:5:5: error missing-key", {"'mode'"}),
                            says("a.campus.yaml:5:5: error missing-key", {"'shape'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shpe: box, size: [1, 1, 1], mode: solid}"),
                ElementsAre(says("a.campus.yaml:5:5: error missing-key", {"'shape'"}),
                            says("a.campus.yaml:5:13: error unknown-key", {"'shpe'", "'shape'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: box, radius: 3, mode: solid}"),
                ElementsAre(says("a.campus.yaml:5:25: error unknown-key", {"'radius'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, nodes: b, shape: mesh, mode: solid, popup: true}"),
                ElementsAre(says("a.campus.yaml:5:56: error missing-key")));
}

TEST_F(ReadCollider, DiagnosesShapesModesAndIds) {
    EXPECT_THAT(folder_.about_collider("{id: a, shape: cube, mode: solid, radius: 1}"),
                ElementsAre(says("a.campus.yaml:5:20: error bad-value", {"'shape'", "'cube'"})));
    EXPECT_THAT(
        folder_.about_collider("{id: a, shape: mesh, mode: [solid, tigger], nodes: b}"),
        ElementsAre(says("a.campus.yaml:5:40: error bad-value", {"'mode'", "'tigger'", "'trigger'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: mesh, mode: [], nodes: b}"),
                ElementsAre(says("a.campus.yaml:5:32: error bad-value", {"'mode'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: mesh, mode: {}, nodes: {}}"),
                ElementsAre(says("a.campus.yaml:5:32: error wrong-type", {"'mode'"}),
                            says("a.campus.yaml:5:43: error wrong-type", {"'nodes'"})));
    EXPECT_THAT(
        folder_.about_collider("{id: _/b, shape: mesh, mode: solid, nodes: ['', [x]], each: yes}"),
        ElementsAre(says("a.campus.yaml:5:10: error bad-value", {"'id'", "'/'", "'_/b'"}),
                    says("a.campus.yaml:5:49: error bad-value"), says("a.campus.yaml:5:53: error wrong-type"),
                    says("a.campus.yaml:5:65: error wrong-type", {"'each'", "'yes'"})));
    for (const char* id : {"a//b", "/a", "a/", "a-", "-a", "a/.b", "a b", "a\xE2\x80\xAE"}) {
        EXPECT_THAT(
            folder_.about_collider("{id: '" + std::string(id) + "', nodes: b, shape: mesh, mode: solid}"),
            ElementsAre(testing::HasSubstr("5:10: error bad-value: 'id'")));
    }
}

TEST_F(ReadCollider, DiagnosesUnknownAndDuplicateNames) {
    EXPECT_THAT(folder_.about_collider("{id: a, building: hat, layer: tres, shape: mesh, mode: solid}"),
                ElementsAre(says("a.campus.yaml:5:23: error unknown-name", {"'hat'", "'hut'"}),
                            says("a.campus.yaml:5:35: error unknown-name", {"'tres'", "'trees'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, nodes: b, shape: mesh, mode: solid}\n"
                                       "  - {id: a, nodes: c, shape: mesh, mode: solid}"),
                ElementsAre(says("a.campus.yaml:6:10: error duplicate-name", {"'a'"})));
}

TEST_F(ReadCollider, DiagnosesNumbers) {
    EXPECT_THAT(
        folder_.about_collider("{id: a, shape: box, mode: solid, center: [0, 0, 0], size: [1, 0, 1]}"),
        ElementsAre(says("a.campus.yaml:5:67: error bad-value", {"'size'", "'0'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: sphere, mode: solid, center: [0, 0, 0], radius: big}"),
                ElementsAre(says("a.campus.yaml:5:68: error wrong-type", {"'radius'", "'big'"})));
    EXPECT_THAT(folder_.about_collider(
                    "{id: a, shape: capsule, mode: solid, base: [0, 0, 0], radius: 1, height: 1.9}"),
                ElementsAre(says("a.campus.yaml:5:78: error bad-value", {"'height'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: wheel, mode: solid, nodes: b, axis: w}"),
                ElementsAre(says("a.campus.yaml:5:56: error bad-value", {"'axis'", "'w'"})));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: wheel, mode: solid, nodes: b, axis: [0, 0, 0]}"),
                ElementsAre(says("a.campus.yaml:5:56: error bad-value", {"'axis'"})));
}

}  // namespace
}  // namespace campuswalk::config
