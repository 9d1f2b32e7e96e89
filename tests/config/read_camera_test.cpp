#include "config/loader/read_camera.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using engine::CameraSettings;
using engine::SnapshotStep;
using engine::View;
using testing::ElementsAre;

constexpr double kDegree = std::numbers::pi / 180.0;

class ReadCamera : public testing::Test {
protected:
    test::ConfigFolder folder_;
};

TEST_F(ReadCamera, PutsEveryKeyWhereItBelongs) {
    ASSERT_THAT(
        folder_.about_walk(
            "campus: a.campus.yaml\n"
            "camera: {view: top, width: 640, height: 480, fov_deg: 90, height_above: 25, distance: 3}\n"
            "steps: [{spawn: gate}]\n"),
        ElementsAre());
    const CameraSettings camera = folder_.run().walk.camera;
    EXPECT_EQ(camera.view, View::top);
    EXPECT_EQ(camera.width, 640);
    EXPECT_EQ(camera.height, 480);
    EXPECT_NEAR(camera.fov, 90 * kDegree, 1e-15);
    EXPECT_EQ(camera.height_above, 25.0);
    EXPECT_EQ(camera.distance, 3.0);
}

TEST_F(ReadCamera, LetsASnapshotDiffer) {
    ASSERT_THAT(folder_.about_walk("campus: a.campus.yaml\n"
                                   "camera: {view: third_person, width: 640, distance: 3}\n"
                                   "steps: [{spawn: gate}, {snapshot: a}, {snapshot: {name: b, view: "
                                   "first_person, fov_deg: 45}}]\n"),
                ElementsAre());
    const engine::Walk walk = folder_.run().walk;
    const auto& first = std::get<SnapshotStep>(walk.steps.at(1));
    EXPECT_EQ(first.name, "a");
    EXPECT_EQ(first.camera.view, View::third_person);
    EXPECT_EQ(first.camera.width, 640);
    const auto& second = std::get<SnapshotStep>(walk.steps.at(2));
    EXPECT_EQ(second.name, "b");
    EXPECT_EQ(second.camera.view, View::first_person);
    EXPECT_NEAR(second.camera.fov, 45 * kDegree, 1e-15);
    EXPECT_EQ(second.camera.width, 640);
    EXPECT_EQ(second.camera.distance, 3.0);
}

TEST_F(ReadCamera, Complains) {
    EXPECT_THAT(
        folder_.about_walk("campus: a.campus.yaml\n"
                           "camera: {view: third, width: 8, height: 0x10, fov_deg: 171, height_above: 0, "
                           "distance: -1, zoom: 2}\n"
                           "steps: [{spawn: gate}]\n"),
        ElementsAre("a.walk.yaml:2:16: error bad-value: 'view' must be one of first_person, third_person, "
                    "top, not 'third'",
                    "a.walk.yaml:2:30: error bad-value: 'width' must be from 16 to 8192, not '8'",
                    "a.walk.yaml:2:41: error wrong-type: 'height' must be a number, not '0x10'",
                    "a.walk.yaml:2:56: error bad-value: 'fov_deg' must be from 1 to 170 degrees, not '171'",
                    "a.walk.yaml:2:75: error bad-value: 'height_above' must be more than 0 and at most "
                    "1000000 m, not '0'",
                    "a.walk.yaml:2:88: error bad-value: 'distance' must be more than 0 and at most 1000000 "
                    "m, not '-1'",
                    "a.walk.yaml:2:92: error unknown-key: unknown key 'zoom' in 'camera'; known here: view, "
                    "width, height, fov_deg, height_above, distance"));
}

}  // namespace
}  // namespace campuswalk::config
