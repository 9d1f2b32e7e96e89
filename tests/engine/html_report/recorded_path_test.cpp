#include "engine/html_report/recorded_path.h"

#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace campuswalk::engine {
namespace {

std::string recording(const std::string& path) {
    return R"({"campuswalk_recording":1,"ticks_per_second":60,"campus":{"name":"a","file":"a.campus.yaml"},)"
           R"("avatar":{"radius":0.3,"height":1.8,"eye_height":1.7},"log":[],"ticks":20,"way":)" +
           path + "}";
}

RecordedPath path(const std::string& text) {
    return read_recorded_path(recording(text)).value();
}

const char* const kStraight =
    R"({"tick":[0,10,1,9],"x":[1000,500,3500,0],"y":[0,0,0,0],"z":[0,-100,0,50],"yaw":[0,0,0,0],"pitch":[0,0,0,0],"cut":[0,2]})";

/// With the same numbers for all columns but the first.
std::string columns(const std::string& ticks, const std::string& x, const std::string& cut) {
    std::string text = "{\"tick\":[" + ticks + "]";
    for (const char* column : {"x", "y", "z", "yaw", "pitch"}) {
        text += std::string(",\"") + column + "\":[" + x + "]";
    }
    return text + ",\"cut\":[" + cut + "]}";
}

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
          std::string("{\"campuswalk_recording\":1}"), recording("{}"), recording(columns("", "", "")),
          recording(columns("0,1", "0", "")), recording(columns("0", "0", "7")),
          recording(columns("\"a\"", "0", "")), recording(R"({"tick":[0],"x":[0],"y":[0],"z":[0],"cut":[]})"),
          "\xEF\xBB\xBF" + recording(kStraight)}) {
        EXPECT_FALSE(read_recorded_path(text)) << text;
    }
}

using RecordingJson = nlohmann::ordered_json;

/// Whatever stands in place of any of its values.
TEST(RecordedPath, IsReadOrNoneWhateverIsInIt) {
    const std::string whole = recording(kStraight);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(read_recorded_path(whole.substr(0, size))) << size;
    }
    const RecordingJson flat = RecordingJson::parse(whole).flatten();
    for (const auto& [pointer, value] : flat.items()) {
        for (RecordingJson::json_pointer at(pointer); !at.empty(); at.pop_back()) {
            for (const char* other :
                 {"null", "true", "1", "-1", "1.5", "\"a\"", "[]", "{}", "[[]]", "[null]"}) {
                RecordingJson changed = RecordingJson::parse(whole);
                changed[at] = RecordingJson::parse(other);
                const auto read = read_recorded_path(changed.dump());
                EXPECT_TRUE(!read || !read->keys.empty()) << changed;
            }
            RecordingJson changed = RecordingJson::parse(whole);
            RecordingJson& parent = changed[at.parent_pointer()];
            if (parent.is_object()) {
                parent.erase(at.back());
                const auto read = read_recorded_path(changed.dump());
                EXPECT_TRUE(!read || !read->keys.empty()) << changed;
            }
        }
    }
}

TEST(RecordedPath, TakesTheLastOfSeveralMembersAsBrowsersDo) {
    std::string twice = recording(kStraight);
    twice.insert(twice.size() - 1, R"(,"log":7)");
    EXPECT_FALSE(read_recorded_path(twice));
    twice.insert(twice.size() - 1, R"(,"log":["a line"])");
    EXPECT_TRUE(read_recorded_path(twice));
}

TEST(RecordedPath, IsNoneIfNoWalkCanHaveLeftIt) {
    EXPECT_TRUE(read_recorded_path(recording(columns("0,1", "0,0", ""))));
    for (const char* ticks :
         {"0,0", "5,-1", "-1,2", "0,4000000000000000000", "0,18446744073709551615", "0,1.5", "0,1e300"}) {
        EXPECT_FALSE(read_recorded_path(recording(columns(ticks, "0,0", "")))) << ticks;
    }
    EXPECT_FALSE(
        read_recorded_path(recording(columns("0,1", "9000000000000000000,9000000000000000000", ""))));
    for (const char* member : {"\"log\":[]", "\"ticks_per_second\":60", "\"radius\":0.3"}) {
        std::string text = recording(kStraight);
        text.replace(text.find(member), std::string(member).size(), "\"other\":0");
        EXPECT_FALSE(read_recorded_path(text)) << member;
    }
    const std::string deep(100'000, '[');
    EXPECT_FALSE(
        read_recorded_path("{\"campuswalk_recording\":" + deep + std::string(deep.size(), ']') + "}"));
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
    const RecordedPath vertex = path("{\"tick\":[" + ticks + "],\"x\":[" + x + "],\"y\":[" + z + "],\"z\":[" +
                                     z + "],\"yaw\":[" + z + "],\"pitch\":[" + z + "],\"cut\":[]}");
    EXPECT_EQ(plan_of(vertex, 3), (std::vector<std::int64_t>{0, 0, 500, 0, 0, 500}));
    EXPECT_EQ(plan_of(vertex).size(), 48U);  // 24 points
}

TEST(RecordedPath, PartsAtTheTickThatATickByTickSearchFinds) {
    std::mt19937 random(3);
    const auto below = [&](int most) {
        return static_cast<std::int64_t>(random() % static_cast<unsigned>(most));
    };
    for (int round = 0; round < 300; ++round) {
        RecordedPath one;
        Tick tick = 0;
        for (int i = 0; i < 6; ++i) {
            one.keys.push_back({tick, {below(20), below(20), below(20)}, i > 0 && below(4) == 0});
            tick += 1 + below(12);
        }
        RecordedPath other = one;
        RecordedPath::Key& changed = other.keys[static_cast<std::size_t>(below(6))];
        changed.at[static_cast<std::size_t>(below(3))] += below(5) - 2;
        std::optional<Tick> expected;
        for (Tick at = 0; at <= one.keys.back().tick && !expected; ++at) {
            if ((one.at(at) - other.at(at)).cwiseAbs().maxCoeff() > 1.0) {
                expected = at;
            }
        }
        EXPECT_EQ(parting_tick(one, other), expected) << round;
    }
    const RecordedPath far = path(columns("0,2000000000", "0,0", ""));
    const RecordedPath farther = path(columns("0,2000000000", "0,1000000", ""));
    EXPECT_EQ(parting_tick(far, farther), 2001);
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
