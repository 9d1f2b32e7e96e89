#include "engine/observers/json_lines.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/observers/text_log.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;
using OrderedJson = nlohmann::ordered_json;

std::vector<std::string> lines_of(const std::vector<Event>& events, double time = 0.0) {
    std::vector<std::string> lines;
    JsonLines json([&](std::string_view line) { lines.emplace_back(line); });
    TickRecord record;
    record.time = time;
    record.events = events;
    json.on_tick(record);
    return lines;
}

std::string line_of(const Event& event, double time = 0.0) {
    return lines_of({event}, time).at(0);
}

TEST(JsonLines, BeginWithTheWalksSettings) {
    std::string header;
    JsonLines json([&](std::string_view line) { header = line; });
    Walk walk;
    walk.name = "first-tour";
    walk.campus_name = "demo";
    json.begin(walk);
    EXPECT_EQ(header, R"({"walk_log":1,"walk":"first-tour","campus":"demo","tps":60})");
    walk.project = "robot";
    walk.timeout = 0.1;
    json.begin(walk);
    EXPECT_TRUE(header.ends_with(R"(,"project":"robot","timeout":0.1})")) << header;
    walk.origin = {{84000, 0, -447000.25}, {}};
    json.begin(walk);
    EXPECT_TRUE(header.ends_with(R"(,"origin":{"at":[84000.0,0.0,-447000.25]}})")) << header;
    walk.origin.geographic = scene::GeographicPlace{51.99875, 4.37325, 43.5, {0, 0, 0}};
    json.begin(walk);
    EXPECT_EQ(OrderedJson::parse(header)["origin"],
              OrderedJson::parse(R"({"at": [84000.0, 0.0, -447000.25], "latitude_deg": 51.99875,
                              "longitude_deg": 4.37325, "height": 43.5, "of": [0.0, 0.0, 0.0]})"));
}

TEST(JsonLines, HaveOneObjectPerEventWithItsFieldsInOrder) {
    const Event event{243,
                      0.375,
                      EventKind::trigger_enter,
                      "library/door",
                      {{"pos", Vector3d(11.0021, -0.0, -7.3096)},
                       {"at", Decimal{0.37512, 3}},
                       {"ticks", std::int64_t{159}},
                       {"cause", std::string("end")},
                       {"title", Text{"Main Library"}}}};
    EXPECT_EQ(line_of(event, 243 / 60.0),
              R"({"tick":243,"time":4.05,"event":"trigger.enter","object":"library/door",)"
              R"("pos":[11.002,0.0,-7.31],"at":0.375,"ticks":159,"cause":"end","title":"Main Library"})");
}

TEST(JsonLines, RoundNumbersAsTheTextLogDoes) {
    support::Dice dice(11);
    for (int i = 0; i < 2000; ++i) {
        const double value = dice.between(-1000.0, 1000.0);
        const Event event{0, 1.0, EventKind::ray_enter, "x", {{"distance", Decimal{value, 3}}}};
        const double shown = OrderedJson::parse(line_of(event)).at("distance").get<double>();
        ASSERT_EQ(shown, std::round(value * 1000.0) / 1000.0) << value;
    }
    const OrderedJson third =
        OrderedJson::parse(line_of({1, 1.0, EventKind::popup_close, "x", {}}, 1.0 / 3.0));
    EXPECT_EQ(third.at("time").get<double>(), 0.333333);
}

TEST(JsonLines, PreserveEveryString) {
    std::string odd = "quote \" backslash \\ slash / newline \n tab \t bell \a Überbau – 図書館";
    for (char c = 1; c < 0x20; ++c) {
        odd += c;
    }
    const std::string line =
        line_of({0, 1.0, EventKind::popup_open, odd, {{"body", Text{odd}}, {"by", odd}}});
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const OrderedJson json = OrderedJson::parse(line);
    EXPECT_EQ(json.at("object"), odd);
    EXPECT_EQ(json.at("body"), odd);
    EXPECT_EQ(json.at("by"), odd);
}

TEST(JsonLines, ReplaceBytesThatAreNotUtf8) {
    const OrderedJson json =
        OrderedJson::parse(line_of({0, 1.0, EventKind::popup_open, "b", {{"t", Text{"caf\xe9!"}}}}));
    EXPECT_EQ(json.at("t"), "caf\xEF\xBF\xBD!");
}

/// A JSON value as the text log prints it, with this many digits after the point.
std::string as_text(const OrderedJson& value, int digits) {
    std::array<char, 64> text{};
    if (value.is_array()) {
        return as_text(value[0], 3) + "," + as_text(value[1], 3) + "," + as_text(value[2], 3);
    }
    if (value.is_number_float()) {
        std::snprintf(text.data(), text.size(), "%.*f", digits, value.get<double>());
        return text.data();
    }
    return value.is_number() ? std::to_string(value.get<std::int64_t>()) : value.get<std::string>();
}

TEST(JsonLines, ContainTheSameValuesAsTheTextLog) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall", "Hall", "08-22", "A \"great\" hall.");
    add_box(campus, "hall/door", {-1, 0, -4}, {1, 2, -3}, {collision::Detection::trigger, "hall", true, ""});
    add_box(campus, "hall/walls", {-3, 0, -9}, {3, 4, -8},
            {collision::Detection::solid | collision::Detection::ray, "hall", true, ""});
    WalkToStep step = walk_to(0.3, -12.0);
    step.if_blocked = IfBlocked::proceed;
    const Walk walk = walk_of({spawn_at({0, 0, 0}), step, snapshot("end"), teleport_to({5, 0, 5}, 1.0)});

    std::vector<std::string> text;
    std::vector<std::string> json;
    TextLog text_log([&](std::string_view line) { text.emplace_back(line); });
    JsonLines json_lines([&](std::string_view line) { json.emplace_back(line); });
    const std::array<Observer*, 2> observers = {&text_log, &json_lines};
    run_walk(campus, walk, observers);

    ASSERT_EQ(text.size(), json.size());
    ASSERT_GT(text.size(), 10U);
    for (std::size_t i = 1; i < json.size(); ++i) {
        const OrderedJson object = OrderedJson::parse(json[i]);
        std::string rebuilt;
        for (const auto& [name, value] : object.items()) {
            if (name == "title" || name == "body" || name == "why") {
                rebuilt += " " + name + "=" + value.dump();
            } else if (name != "tick" && name != "time" && name != "event" && name != "object") {
                rebuilt += " " + name + "=" + as_text(value, name == "yaw" ? 1 : 3);
            }
        }
        EXPECT_TRUE(text[i].ends_with(rebuilt)) << text[i] << "\n" << rebuilt;
        const std::string time = as_text(object.at("time"), 6);
        EXPECT_EQ(std::stoll(text[i]), object.at("tick").get<std::int64_t>());
        EXPECT_EQ(text[i].substr(7, 12), std::string(11 - time.size(), ' ') + time + " ");
        EXPECT_EQ(text[i].find(object.at("event").get<std::string>()), 19U) << text[i];
        EXPECT_EQ(text[i].find(object.at("object").get<std::string>(), 36), 36U) << text[i];
    }
}

}  // namespace
}  // namespace campuswalk::engine
