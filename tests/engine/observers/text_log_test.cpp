#include "engine/observers/text_log.h"

#include "engine/events/event_text.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

Event event(Tick tick, EventKind kind, const std::string& object, std::vector<Field> fields = {}) {
    return {tick, 1.0, kind, object, std::move(fields)};
}

// The example in the specification of the log's format.
TEST(TextLog, PrintsExactlyTheSpecifiedLines) {
    std::vector<std::string> lines;
    TextLog log([&](std::string_view line) { lines.emplace_back(line); });
    Walk walk;
    walk.name = "first-tour";
    walk.campus_name = "demo";
    log.begin(walk);
    const std::vector<Event> events = {
        event(0, EventKind::walk_start, "first-tour",
              {{"pos", Vector3d(0, 0, 24)}, {"yaw", Decimal{-0.0, 1}}}),
        event(243, EventKind::trigger_enter, "library/door",
              {{"pos", Vector3d(11.002, -0.0, -7.31)}, {"at", Decimal{0.375, 3}}}),
        event(243, EventKind::popup_open, "library",
              {{"title", Text{"Main Library"}}, {"body", Text{"Open 08-22. Four floors."}}}),
        event(402, EventKind::popup_close, "library"),
        event(402, EventKind::trigger_exit, "library/door",
              {{"pos", Vector3d(10.884, 0, -6.12)}, {"at", Decimal{0.12, 3}}, {"ticks", std::int64_t{159}}}),
        event(3110, EventKind::walk_end, "first-tour",
              {{"result", std::string("pass")},
               {"events", std::int64_t{9}},
               {"dist", Decimal{61.204, 3}},
               {"hash", std::string("9f2c41d07be8a31c")}})};
    for (const Event& e : events) {
        TickRecord record;
        record.tick = e.tick;
        record.time = static_cast<double>(e.tick) / 60.0;
        record.events = {&e, 1};
        log.on_tick(record);
    }
    const std::vector<std::string> expected = {
        R"(# walk-log 1 walk=first-tour campus=demo tps=60)",
        R"(000000    0.000000 walk.start       first-tour        pos=0.000,0.000,24.000 yaw=0.0)",
        R"(000243    4.050000 trigger.enter    library/door      pos=11.002,0.000,-7.310 at=0.375)",
        R"(000243    4.050000 popup.open       library           title="Main Library" body="Open 08-22. Four floors.")",
        R"(000402    6.700000 popup.close      library)",
        R"(000402    6.700000 trigger.exit     library/door      pos=10.884,0.000,-6.120 at=0.120 ticks=159)",
        R"(003110   51.833333 walk.end         first-tour        result=pass events=9 dist=61.204 hash=9f2c41d07be8a31c)",
    };
    EXPECT_EQ(lines, expected);
}

TEST(TextLog, BeginsWithTheWalksSettings) {
    std::string header;
    TextLog log([&](std::string_view line) { header = line; });
    Walk walk;
    walk.name = "up the hill";
    walk.campus_name = "north";
    walk.sim.ticks_per_second = 120;
    log.begin(walk);
    EXPECT_EQ(header, "# walk-log 1 walk=\"up the hill\" campus=north tps=120");
    walk.project = "robot";
    walk.timeout = 0.1;
    log.begin(walk);
    EXPECT_TRUE(header.ends_with(" project=robot timeout=0.100")) << header;
    walk.timeout.reset();
    walk.project.clear();
    walk.origin = {{84000, 0, -447000.25}, scene::GeographicPlace{51.99875, 4.37325, 43.5, {1, 0, -2}}};
    log.begin(walk);
    EXPECT_TRUE(
        header.ends_with(" origin=84000.000,0.000,-447000.250 latitude_deg=51.99875000 "
                         "longitude_deg=4.37325000 height=43.500 of=1.000,0.000,-2.000"))
        << header;
}

TEST(TextLog, PrintsNothingWithoutEvents) {
    int lines = 0;
    TextLog log([&](std::string_view) { ++lines; });
    log.on_tick(TickRecord{});
    log.end();
    EXPECT_EQ(lines, 0);
}

TEST(TextLog, ShiftsTheRestOfTheLineAfterAWideColumn) {
    const std::string id = "tree/a-very-long-name-of-a-tree";
    EXPECT_EQ(
        text_line(event(12345678, EventKind::collision_enter, id, {{"ticks", std::int64_t{1}}}), 1234567.5),
        "12345678 1234567.500000 collision.enter  " + id + " ticks=1");
    EXPECT_EQ(text_line(event(1, EventKind::avatar_teleport, "x"), 100000.0),
              "000001 100000.000000 avatar.teleport  x");
}

TEST(TextLog, EscapesTextToKeepItOnOneLine) {
    const auto quoted = [](const std::string& text) {
        const std::string line = text_line(event(0, EventKind::popup_open, "b", {{"t", Text{text}}}), 0.0);
        return line.substr(line.find("t=") + 2);
    };
    EXPECT_EQ(quoted(""), R"("")");
    EXPECT_EQ(quoted("two words"), R"("two words")");
    EXPECT_EQ(quoted("say \"hi\""), R"("say \"hi\"")");
    EXPECT_EQ(quoted("back\\slash"), R"("back\\slash")");
    EXPECT_EQ(quoted("one\ntwo"), R"("one\ntwo")");
    EXPECT_EQ(quoted("tab\there"), R"("tab\x09here")");
    EXPECT_EQ(quoted("\x1b[31mred\x7f\r"), R"("\x1b[31mred\x7f\x0d")");
    EXPECT_EQ(quoted(std::string("nul\0.", 5)), R"("nul\x00.")");
    EXPECT_EQ(quoted("Überbau – 図書館"), "\"Überbau – 図書館\"") << "UTF-8 is unchanged";
}

TEST(TextLog, QuotesANameOnlyIfItWouldBreakTheLine) {
    const auto shown = [](const std::string& name) {
        const std::string line = text_line(event(0, EventKind::avatar_blocked, "b", {{"by", name}}), 0.0);
        return line.substr(line.find("by=") + 3);
    };
    EXPECT_EQ(shown("tree/lime-009"), "tree/lime-009");
    EXPECT_EQ(shown("Überbau"), "Überbau");
    EXPECT_EQ(shown("3,-4.5"), "3,-4.5");
    EXPECT_EQ(shown(""), R"("")");
    EXPECT_EQ(shown("two words"), R"("two words")");
    EXPECT_EQ(shown("a=b"), R"("a=b")");
    EXPECT_EQ(shown("a\rb"), R"("a\x0db")");
    EXPECT_EQ(text_line(event(7, EventKind::avatar_landed, "my walk", {{"height", Decimal{3, 3}}}), 0.5),
              "000007    0.500000 avatar.landed    \"my walk\"         height=3.000");
    EXPECT_EQ(text_line(event(7, EventKind::popup_close, "a b"), 0.5),
              "000007    0.500000 popup.close      \"a b\"");
}

TEST(TextLog, PropagatesAnExceptionOfTheSink) {
    TextLog log([](std::string_view) { throw std::runtime_error("disk full"); });
    EXPECT_THROW(log.begin(Walk{}), std::runtime_error);
}

}  // namespace
}  // namespace campuswalk::engine
