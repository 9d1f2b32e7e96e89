#include "engine/html_report/recorded_path.h"

#include <string>

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

std::string recording(const std::string& path) {
    return R"({"campuswalk_recording":1,"campus":{"name":"a","file":"a.campus.yaml"},"way":)" + path + "}";
}

RecordedPath path(const std::string& text) {
    return read_recorded_path(recording(text)).value();
}

const char* const kStraight =
    R"({"tick":[0,10,1,9],"x":[1000,500,3500,0],"y":[0,0,0,0],"z":[0,-100,0,50],"yaw":[0,0,0,0],"pitch":[0,0,0,0],"cut":[0,2]})";

TEST(RecordedPath, IsLinearBetweenKeysAndHoldsUntilACut) {
    const RecordedPath straight = path(kStraight);
    EXPECT_EQ(straight.campus_file, "a.campus.yaml");
    EXPECT_EQ(straight.at(0), Eigen::Vector3d(1000, 0, 0));
    EXPECT_EQ(straight.at(5), Eigen::Vector3d(1250, 0, -50));
    EXPECT_EQ(straight.at(10), Eigen::Vector3d(1500, 0, -100));
    EXPECT_EQ(straight.at(11), Eigen::Vector3d(5000, 0, -100));
    EXPECT_EQ(straight.at(20), Eigen::Vector3d(5000, 0, -50));
    EXPECT_EQ(straight.at(99), Eigen::Vector3d(5000, 0, -50));
}

TEST(RecordedPath, OtherTextIsNone) {
    for (const std::string& text :
         {std::string(), std::string("["), std::string("[]"), std::string("{\"campuswalk_recording\":2}"),
          std::string("{\"campuswalk_recording\":1}"), recording("{}"),
          recording(R"({"tick":[],"x":[],"y":[],"z":[],"cut":[]})"),
          recording(R"({"tick":[0,1],"x":[0],"y":[0],"z":[0],"cut":[]})"),
          recording(R"({"tick":[0],"x":[0],"y":[0],"z":[0],"cut":[7]})"),
          recording(R"({"tick":["a"],"x":[0],"y":[0],"z":[0],"cut":[]})")}) {
        EXPECT_FALSE(read_recorded_path(text)) << text;
    }
}

TEST(RecordedPath, ThePlanKeepsTheVertices) {
    std::string ticks = "0";
    std::string x = "0";
    std::string z = "0";
    for (int i = 1; i <= 100; ++i) {  // 50 steps east, then 50 south
        ticks += ",1";
        x += i <= 50 ? ",1000" : ",0";
        z += i <= 50 ? ",0" : ",1000";
    }
    const RecordedPath vertex =
        path("{\"tick\":[" + ticks + "],\"x\":[" + x + "],\"y\":[" + z + "],\"z\":[" + z + "],\"cut\":[]}");
    EXPECT_EQ(plan_of(vertex, 3), (std::vector<std::int64_t>{0, 0, 500, 0, 0, 500}));
    EXPECT_EQ(plan_of(vertex).size(), 48U);  // 24 points
}

TEST(RecordedPath, PartsWhereItIsMoreThanAMillimetreOff) {
    const RecordedPath straight = path(kStraight);
    EXPECT_FALSE(parting_tick(straight, straight));
    RecordedPath other = straight;
    other.keys[1].at[0] += 10;  // grows from tick 0 to 10: more than 1 mm from tick 2 on
    EXPECT_EQ(parting_tick(straight, other), 2);
    other = straight;
    other.keys.back().tick = 15;
    other.keys.back().at = straight.keys[2].at;
    RecordedPath shorter = straight;
    shorter.keys.pop_back();
    EXPECT_EQ(parting_tick(shorter, other), 12);
}

}  // namespace
}  // namespace campuswalk::engine
