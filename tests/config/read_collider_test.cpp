#include "config/loader/read_collider.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using scene::ColliderDescription;
using testing::ElementsAre;

class ReadCollider : public testing::Test {
protected:
    ColliderDescription read(const std::string& text) {
        EXPECT_THAT(folder_.about_collider(text), ElementsAre());
        return folder_.campus().colliders.at(0);
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadCollider, ReadsWhatAllShapesShare) {
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
                ElementsAre("a.campus.yaml:5:5: error missing-key: a collider needs the key 'id'",
                            "a.campus.yaml:5:5: error missing-key: a collider needs the key 'mode'",
                            "a.campus.yaml:5:5: error missing-key: a collider needs the key 'shape'"));
    EXPECT_THAT(folder_.about_collider("{id: a, shpe: box, size: [1, 1, 1], mode: solid}"),
                ElementsAre("a.campus.yaml:5:5: error missing-key: a collider needs the key 'shape'",
                            "a.campus.yaml:5:13: error unknown-key: unknown key 'shpe' in a collider (did "
                            "you mean 'shape'?)"));
    EXPECT_THAT(
        folder_.about_collider("{id: a, shape: box, radius: 3, mode: solid}"),
        ElementsAre("a.campus.yaml:5:25: error unknown-key: unknown key 'radius' in a collider; known here: "
                    "id, building, popup, nodes, except, each, layer, mode, shape, center, size, "
                    "yaw_deg"));
    EXPECT_THAT(
        folder_.about_collider("{id: a, nodes: b, shape: mesh, mode: solid, popup: true}"),
        ElementsAre(
            "a.campus.yaml:5:56: error missing-key: a collider with a pop-up needs the key 'building'"));
}

TEST_F(ReadCollider, DiagnosesWords) {
    EXPECT_THAT(folder_.about_collider("{id: a, shape: cube, mode: solid, radius: 1}"),
                ElementsAre("a.campus.yaml:5:20: error bad-value: 'shape' must be one of mesh, box, sphere, "
                            "capsule, wheel, not 'cube'"));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: mesh, mode: [solid, tigger], nodes: b}"),
                ElementsAre("a.campus.yaml:5:40: error bad-value: 'mode' must be one of solid, trigger, ray, "
                            "not 'tigger' (did you mean 'trigger'?)"));
    EXPECT_THAT(
        folder_.about_collider("{id: a, shape: mesh, mode: [], nodes: b}"),
        ElementsAre(
            "a.campus.yaml:5:32: error bad-value: 'mode' must be solid, trigger or ray, or a list of them"));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: mesh, mode: {}, nodes: {}}"),
                ElementsAre("a.campus.yaml:5:32: error wrong-type: 'mode' must be a single value or a list, "
                            "not a map of keys",
                            "a.campus.yaml:5:43: error wrong-type: 'nodes' must be a single value or a list, "
                            "not a map of keys"));
    EXPECT_THAT(
        folder_.about_collider("{id: A/b, shape: mesh, mode: solid, nodes: ['', [x]], each: yes}"),
        ElementsAre("a.campus.yaml:5:10: error bad-value: 'id' must be small letters, digits and single "
                    "hyphens, with '/' between words, as in library/door, not 'A/b'",
                    "a.campus.yaml:5:49: error bad-value: a node glob must be one line of text and not empty",
                    "a.campus.yaml:5:53: error wrong-type: a node glob must be a text, not a list",
                    "a.campus.yaml:5:65: error wrong-type: 'each' must be true or false, not 'yes'"));
    for (const char* id : {"a//b", "/a", "a/", "a--b", "-a", "a_b", "a b"}) {
        EXPECT_THAT(
            folder_.about_collider("{id: '" + std::string(id) + "', nodes: b, shape: mesh, mode: solid}"),
            ElementsAre(testing::HasSubstr("5:10: error bad-value: 'id' must be small letters")));
    }
}

TEST_F(ReadCollider, DiagnosesNames) {
    EXPECT_THAT(
        folder_.about_collider("{id: a, building: hat, layer: tres, shape: mesh, mode: solid}"),
        ElementsAre(
            "a.campus.yaml:5:23: error unknown-name: 'hat' is not in 'buildings' (did you mean 'hut'?)",
            "a.campus.yaml:5:35: error unknown-name: 'tres' is not in 'layers' (did you mean 'trees'?)"));
    EXPECT_THAT(
        folder_.about_collider("{id: a, nodes: b, shape: mesh, mode: solid}\n"
                               "  - {id: a, nodes: c, shape: mesh, mode: solid}"),
        ElementsAre("a.campus.yaml:6:10: error duplicate-name: the collider 'a' stands on line 5 already"));
}

TEST_F(ReadCollider, DiagnosesNumbers) {
    EXPECT_THAT(
        folder_.about_collider("{id: a, shape: box, mode: solid, center: [0, 0, 0], size: [1, 0, 1]}"),
        ElementsAre("a.campus.yaml:5:67: error bad-value: 'size' must be more than 0 and at most 1000000 m, "
                    "not '0'"));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: sphere, mode: solid, center: [0, 0, 0], radius: big}"),
                ElementsAre("a.campus.yaml:5:68: error wrong-type: 'radius' must be a number, not 'big'"));
    EXPECT_THAT(folder_.about_collider(
                    "{id: a, shape: capsule, mode: solid, base: [0, 0, 0], radius: 1, height: 1.9}"),
                ElementsAre("a.campus.yaml:5:78: error bad-value: 'height' is the capsule's total height, at "
                            "least twice its radius of 1 m"));
    EXPECT_THAT(folder_.about_collider("{id: a, shape: wheel, mode: solid, nodes: b, axis: w}"),
                ElementsAre("a.campus.yaml:5:56: error bad-value: 'axis' must be one of x, y, z, not 'w'"));
    EXPECT_THAT(
        folder_.about_collider("{id: a, shape: wheel, mode: solid, nodes: b, axis: [0, 0, 0]}"),
        ElementsAre("a.campus.yaml:5:56: error bad-value: 'axis' must have a direction, not [0, 0, 0]"));
}

}  // namespace
}  // namespace campuswalk::config
