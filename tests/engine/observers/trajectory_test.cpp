#include "engine/observers/trajectory.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

struct Files {
    std::vector<std::string> csv;
    std::vector<std::string> tum;
    Recorder recorder;
    WalkSummary summary;
};

Files files_of(const Walk& walk) {
    Files files;
    TrajectoryCsv csv([&](std::string_view line) { files.csv.emplace_back(line); });
    TrajectoryTum tum([&](std::string_view line) { files.tum.emplace_back(line); });
    const std::array<Observer*, 3> observers = {&csv, &tum, &files.recorder};
    files.summary = run_walk(level_campus(), walk, observers);
    return files;
}

TEST(Trajectory, HasOneLinePerTick) {
    const Files files =
        files_of(walk_of({spawn_at({1, 0, 2}), walk_to(3.0, -1.0), turn_by(100), set_height(1.0)}));
    const auto ticks = static_cast<std::size_t>(files.summary.ticks) + 1;
    ASSERT_EQ(files.csv.size(), ticks + 1);
    ASSERT_EQ(files.tum.size(), ticks);
    EXPECT_EQ(files.csv[0], "t,x,y,z,yaw_deg,pitch_deg,grounded,height");
    EXPECT_EQ(files.csv[1].substr(0, 48), "0.000000000,1.000000000,0.000000000,2.000000000,");
    for (std::size_t i = 0; i < ticks; ++i) {
        const AvatarState& avatar = files.recorder.at(static_cast<Tick>(i));
        double t = 0, x = 0, y = 0, z = 0, yaw = 0, pitch = 0, height = 0;
        int grounded = 0;
        ASSERT_EQ(std::sscanf(files.csv[i + 1].c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%d,%lf", &t, &x, &y, &z,
                              &yaw, &pitch, &grounded, &height),
                  8);
        EXPECT_NEAR(t, static_cast<double>(i) / 60.0, 1e-9);
        EXPECT_LT((Eigen::Vector3d(x, y, z) - avatar.position).norm(), 2e-9);
        EXPECT_NEAR(yaw, avatar.yaw * 180.0 / std::numbers::pi, 1e-9);
        EXPECT_EQ(grounded != 0, avatar.grounded);
        EXPECT_NEAR(height, avatar.stature * 1.8, 1e-9);
    }
    EXPECT_TRUE(files.csv.back().ends_with(",1,1.000000000")) << files.csv.back();
}

TEST(Trajectory, HasTheOrientationOfTheEyesAsAQuaternion) {
    support::Dice dice(3);
    for (int i = 0; i < 200; ++i) {
        TickRecord record;
        record.avatar.position = dice.in_cube(100.0);
        record.avatar.yaw = dice.between(-2.0 * std::numbers::pi, 2.0 * std::numbers::pi);
        record.avatar.pitch = dice.between(-1.5, 1.5);
        std::string line;
        TrajectoryTum tum([&](std::string_view text) { line = text; });
        tum.on_tick(record);
        double t = 0;
        Eigen::Vector3d at;
        Eigen::Quaterniond q;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf %lf %lf %lf %lf %lf %lf %lf", &t, &at.x(), &at.y(), &at.z(),
                              &q.x(), &q.y(), &q.z(), &q.w()),
                  8);
        const Eigen::Matrix3d turned = (Eigen::AngleAxisd(record.avatar.yaw, Eigen::Vector3d::UnitY()) *
                                        Eigen::AngleAxisd(record.avatar.pitch, Eigen::Vector3d::UnitX()))
                                           .toRotationMatrix();
        EXPECT_LT((q.toRotationMatrix() - turned).norm(), 1e-7) << line;
        EXPECT_GE(q.w(), 0.0);
        EXPECT_LT((at - record.avatar.position).norm(), 2e-9);
    }
}

}  // namespace
}  // namespace campuswalk::engine
