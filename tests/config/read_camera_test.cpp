#include "config/loader/walk/read_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/angles.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using engine::CameraSettings;
using engine::FirstPersonView;
using engine::FixedView;
using engine::OrbitView;
using engine::SnapshotStep;
using engine::ThirdPersonView;
using engine::TopView;
using support::radians;
using support::says;
using testing::ElementsAre;

class ReadCamera : public testing::Test {
protected:
    test::ConfigFolder folder_;
};

TEST_F(ReadCamera, ReadsEveryKey) {
    ASSERT_THAT(
        folder_.about_walk(
            "campus: a.campus.yaml\n"
            "camera: {view: top, width: 640, height: 480, fov_deg: 90, height_above: 25, distance: 3}\n"
            "steps: [{spawn: gate}]\n"),
        ElementsAre());
    const engine::Walk walk = folder_.run().walk;
    const CameraSettings& camera = walk.camera;
    EXPECT_EQ(camera.width, 640);
    EXPECT_EQ(camera.height, 480);
    EXPECT_NEAR(camera.fov, radians(90), 1e-15);
    EXPECT_EQ(std::get<TopView>(camera.view).height_above, 25.0);
    // The other views, which video frames may use, have the keys too.
    EXPECT_EQ(std::get<ThirdPersonView>(walk.views[1]).distance, 3.0);
    EXPECT_EQ(std::get<OrbitView>(walk.views[3]).distance, 3.0);
}

TEST_F(ReadCamera, LetsASnapshotOverrideTheCamera) {
    ASSERT_THAT(folder_.about_walk("campus: a.campus.yaml\n"
                                   "camera: {view: third_person, width: 640, distance: 3}\n"
                                   "steps: [{spawn: gate}, {snapshot: a}, {snapshot: {name: b, view: "
                                   "first_person, fov_deg: 45}}, {snapshot: {name: c, view: orbit}}]\n"),
                ElementsAre());
    const engine::Walk walk = folder_.run().walk;
    const auto& first = std::get<SnapshotStep>(walk.steps.at(1));
    EXPECT_EQ(first.name, "a");
    EXPECT_EQ(std::get<ThirdPersonView>(first.camera.view).distance, 3.0);
    EXPECT_EQ(first.camera.width, 640);
    const auto& second = std::get<SnapshotStep>(walk.steps.at(2));
    EXPECT_EQ(second.name, "b");
    EXPECT_TRUE(std::holds_alternative<FirstPersonView>(second.camera.view));
    EXPECT_NEAR(second.camera.fov, radians(45), 1e-15);
    EXPECT_EQ(second.camera.width, 640);
    const auto& third = std::get<SnapshotStep>(walk.steps.at(3));
    EXPECT_EQ(std::get<OrbitView>(third.camera.view).distance, 3.0) << "from the walk's camera";
}

TEST_F(ReadCamera, ResolvesCameraTargets) {
    ASSERT_THAT(
        folder_.about_walk("campus: a.campus.yaml\n"
                           "camera: {view: orbit, around: hut, yaw_deg: 45, pitch_deg: -30}\n"
                           "steps:\n"
                           "  - spawn: gate\n"
                           "  - snapshot: a\n"
                           "  - snapshot: {name: b, around: [1, 2, 3], distance: 20}\n"
                           "  - snapshot: {name: c, view: fixed, position: [4, 5, 6], look_at: gate}\n"),
        ElementsAre());
    const engine::Walk walk = folder_.run().walk;
    const auto& a = std::get<OrbitView>(std::get<SnapshotStep>(walk.steps.at(1)).camera.view);
    EXPECT_EQ(a.around->building, 0U);
    EXPECT_NEAR(*a.yaw, radians(45), 1e-15);
    EXPECT_NEAR(*a.pitch, radians(-30), 1e-15);
    EXPECT_FALSE(a.distance);
    const auto& b = std::get<OrbitView>(std::get<SnapshotStep>(walk.steps.at(2)).camera.view);
    EXPECT_FALSE(b.around->building);
    EXPECT_EQ(b.around->point, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(b.distance, 20.0);
    const auto& c = std::get<FixedView>(std::get<SnapshotStep>(walk.steps.at(3)).camera.view);
    EXPECT_EQ(c.position, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(c.look_at->label, "gate");
    EXPECT_FALSE(c.yaw) << "replaced by look_at";
}

TEST_F(ReadCamera, DiagnosesKeysThatASnapshotsViewDoesNotUse) {
    const auto about = [&](const std::string& snapshot) {
        return folder_.about_walk("campus: a.campus.yaml\nsteps:\n  - spawn: gate\n  - snapshot: {name: a, " +
                                  snapshot + "}\n");
    };
    const std::vector<std::pair<std::string, std::string>> unused = {
        {"pitch_deg: -10", "first_person"},       {"view: third_person, yaw_deg: 5", "third_person"},
        {"view: top, distance: 5", "top"},        {"view: orbit, height_above: 5", "orbit"},
        {"view: orbit, look_at: gate", "orbit"},  {"view: third_person, around: gate", "third_person"},
        {"view: top, position: [1, 2, 3]", "top"}};
    for (const auto& [keys, view] : unused) {
        EXPECT_THAT(about(keys), ElementsAre(testing::AllOf(testing::HasSubstr("a.walk.yaml:4:"),
                                                            testing::HasSubstr("bad-value"),
                                                            testing::HasSubstr(" " + view + " "))))
            << keys;
    }
    EXPECT_THAT(about("view: third_person, distance: 5"), ElementsAre());
    EXPECT_THAT(about("view: fixed, position: [1, 2, 3], pitch_deg: 10"), ElementsAre());
}

TEST_F(ReadCamera, ReadsChannels) {
    ASSERT_THAT(folder_.about_walk("campus: a.campus.yaml\n"
                                   "steps: [{spawn: gate}, {snapshot: {name: a, channels: [ids, depth]}}, "
                                   "{snapshot: {name: b, channels: normals}}]\n"),
                ElementsAre());
    const engine::Walk walk = folder_.run().walk;
    const auto& a = std::get<SnapshotStep>(walk.steps.at(1)).channels;
    EXPECT_TRUE(a.depth && a.ids && !a.normals);
    const auto& b = std::get<SnapshotStep>(walk.steps.at(2)).channels;
    EXPECT_TRUE(!b.depth && !b.ids && b.normals);
}

TEST_F(ReadCamera, ReadsOverlays) {
    ASSERT_THAT(folder_.about_walk(
                    "campus: a.campus.yaml\n"
                    "steps: [{spawn: gate}, {snapshot: {name: a, overlays: [path, labels], tree_level: 3}}, "
                    "{snapshot: {name: b, overlays: colliders}}]\n"),
                ElementsAre());
    const engine::Walk walk = folder_.run().walk;
    const auto& a = std::get<SnapshotStep>(walk.steps.at(1)).overlays;
    EXPECT_TRUE(a.path && a.labels && !a.colliders && !a.compass && !a.contacts && !a.triggers);
    EXPECT_EQ(a.tree_level, 3);
    EXPECT_TRUE(std::get<SnapshotStep>(walk.steps.at(2)).overlays.colliders);
    EXPECT_THAT(folder_.about_walk("campus: a.campus.yaml\n"
                                   "steps: [{spawn: gate}, {snapshot: {name: a, overlays: gird}}]\n"),
                ElementsAre(says("a.walk.yaml:2:55: error bad-value", {"'gird'"})));
}

TEST_F(ReadCamera, AllowsAGridFromAboveOnly) {
    ASSERT_THAT(
        folder_.about_walk("campus: a.campus.yaml\n"
                           "steps: [{spawn: gate}, {snapshot: {name: a, view: top, overlays: grid}}]\n"),
        ElementsAre());
    EXPECT_TRUE(std::get<SnapshotStep>(folder_.run().walk.steps.at(1)).overlays.grid);
    EXPECT_THAT(folder_.about_walk("campus: a.campus.yaml\n"
                                   "steps: [{spawn: gate}, {snapshot: {name: a, overlays: [path, grid]}}]\n"),
                ElementsAre(says("a.walk.yaml:2:55: error bad-value", {"'grid'", "view: top"})));
}

TEST_F(ReadCamera, DiagnosesTargetsAndChannels) {
    EXPECT_THAT(
        folder_.about_walk(
            "campus: a.campus.yaml\n"
            "steps:\n"
            "  - spawn: gate\n"
            "  - snapshot: {name: a, view: orbit, around: hutt}\n"
            "  - snapshot: {name: b, view: orbit, around: [1, 2]}\n"
            "  - snapshot: {name: c, view: fixed}\n"
            "  - snapshot: {name: d, view: fixed, position: [0, 1, 0], look_at: gate, yaw_deg: 3}\n"
            "  - snapshot: {name: e, channels: [depth, colors]}\n"
            "  - snapshot: {name: f, channels: depth}\n"
            "  - snapshot: f-depth\n"
            "  - snapshot: {name: g, view: orbit, pitch_deg: 91}\n"),
        ElementsAre(says("a.walk.yaml:4:46: error unknown-name", {"'hutt'", "'hut'"}),
                    says("a.walk.yaml:5:46: error bad-value", {"'around'"}),
                    says("a.walk.yaml:7:68: error bad-value", {"'look_at'", "'yaw_deg'", "'pitch_deg'"}),
                    says("a.walk.yaml:8:43: error bad-value", {"'colors'"}),
                    says("a.walk.yaml:10:15: error duplicate-name", {"'f-depth'"}),
                    says("a.walk.yaml:11:49: error bad-value", {"'pitch_deg'", "'91'"})));
}

TEST_F(ReadCamera, DiagnosesBadValues) {
    EXPECT_THAT(
        folder_.about_walk("campus: a.campus.yaml\n"
                           "camera: {view: third, width: 8, height: 0x10, fov_deg: 171, height_above: 0, "
                           "distance: -1, zoom: 2}\n"
                           "steps: [{spawn: gate}]\n"),
        ElementsAre(says("a.walk.yaml:2:16: error bad-value", {"'view'", "'third'"}),
                    says("a.walk.yaml:2:30: error bad-value", {"'width'", "'8'"}),
                    says("a.walk.yaml:2:41: error wrong-type", {"'height'", "'0x10'"}),
                    says("a.walk.yaml:2:56: error bad-value", {"'fov_deg'", "'171'"}),
                    says("a.walk.yaml:2:75: error bad-value", {"'height_above'", "'0'"}),
                    says("a.walk.yaml:2:88: error bad-value", {"'distance'", "'-1'"}),
                    says("a.walk.yaml:2:92: error unknown-key", {"'zoom'", "'camera'"})));
}

}  // namespace
}  // namespace campuswalk::config
