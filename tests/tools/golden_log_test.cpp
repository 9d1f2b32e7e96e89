#include "tools/campuswalk/logs/golden_log.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/base/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk/logs/log_lines.h"

namespace campuswalk::tools {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;

using Lines = std::vector<std::string>;

const std::string kHeader = R"({"walk_log":1,"walk":"visit","campus":"school","tps":60})";
const std::string kStart =
    R"({"tick":0,"time":0.0,"event":"walk.start","object":"visit","pos":[0.0,0.0,5.0]})";
const std::string kEnter =
    R"({"tick":60,"time":1.0,"event":"trigger.enter","object":"door","pos":[0.0,0.0,3.6],"at":0.25})";

std::string end_line(const std::string& result, int events, const std::string& hash = "00000000000000ab") {
    return R"({"tick":90,"time":1.5,"event":"walk.end","object":"visit","result":")" + result +
           R"(","events":)" + std::to_string(events) + R"(,"dist":2.1,"hash":")" + hash + R"("})";
}

const Lines kLog = {kHeader, kStart, kEnter, end_line("pass", 1)};

TEST(LogLines, KeepTheirColumnsApartInLongWalks) {
    EXPECT_EQ(as_text_line(R"({"tick":600000,"time":10000.0,"event":"trigger.enter","object":"door"})")
                  .substr(0, 20),
              "600000 10000.000000 ");
    EXPECT_EQ(as_text_line(kEnter).substr(0, 33), "000060    1.000000 trigger.enter ");
}

class GoldenLog : public testing::Test {
protected:
    /// Compares, and writes what is to be written.
    GoldenCheck check(const Lines& lines, UpdateSnapshots mode, const std::string& project = "") const {
        GoldenCheck checked = check_golden(walk_, project, lines, mode);
        if (checked.update) {
            scene::write_file_atomically(checked.update->file, checked.update->bytes);
        }
        return checked;
    }
    std::string file(const std::string& name = "log.jsonl") const {
        std::ifstream stream(folder_.path() / "visit.walk.yaml-snapshots" / name);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    /// The failure's message for these lines when kLog is the golden log; empty if there is none.
    std::string diagnostic(const Lines& lines) const {
        check(kLog, UpdateSnapshots::all);
        const GoldenCheck checked = check(lines, UpdateSnapshots::none);
        return checked.failure ? checked.failure->message : "";
    }

    support::TemporaryFolder folder_;
    fs::path walk_ = folder_.path() / "visit.walk.yaml";
    const std::string text_ = kHeader + "\n" + kStart + "\n" + kEnter + "\n" + end_line("pass", 1) + "\n";
    const Lines other_ = {kHeader, kStart, end_line("pass", 0)};
};

TEST_F(GoldenLog, IgnoresATimeoutThatWasNotReached) {
    const std::string header = kHeader.substr(0, kHeader.size() - 1);
    EXPECT_EQ(diagnostic({header + R"(,"timeout":60.0})", kStart, kEnter, end_line("pass", 1)}), "");
    EXPECT_THAT(diagnostic({header + R"(,"project":"near"})", kStart, kEnter, end_line("pass", 1)}),
                HasSubstr("project=near"));
}

TEST_F(GoldenLog, IsWrittenWhereItIsMissing) {
    const GoldenCheck checked = check(kLog, UpdateSnapshots::missing);
    EXPECT_FALSE(checked.failure);
    ASSERT_TRUE(checked.update);
    EXPECT_EQ(checked.update->file, golden_log_file(walk_, ""));
    EXPECT_EQ(file(), text_);
    EXPECT_FALSE(check(kLog, UpdateSnapshots::missing).update);
}

TEST_F(GoldenLog, IsOneFilePerProject) {
    check(kLog, UpdateSnapshots::missing);
    check(other_, UpdateSnapshots::missing, "kiosk");
    EXPECT_EQ(file(), text_);
    EXPECT_FALSE(check(other_, UpdateSnapshots::none, "kiosk").failure);
    EXPECT_TRUE(check(other_, UpdateSnapshots::none).failure);
}

TEST_F(GoldenLog, FailsIfMissingAndMayNotBeWritten) {
    const GoldenCheck checked = check(kLog, UpdateSnapshots::none);
    ASSERT_TRUE(checked.failure);
    EXPECT_EQ(checked.failure->code, "golden-missing");
    EXPECT_THAT(checked.failure->message, HasSubstr("run with -u"));
    EXPECT_FALSE(fs::exists(folder_.path() / "visit.walk.yaml-snapshots"));
}

TEST_F(GoldenLog, IsReplacedOnlyOnRequest) {
    check(kLog, UpdateSnapshots::missing);
    for (const UpdateSnapshots mode : {UpdateSnapshots::missing, UpdateSnapshots::none}) {
        const GoldenCheck checked = check(other_, mode);
        EXPECT_TRUE(checked.failure);
        EXPECT_FALSE(checked.update);
        EXPECT_EQ(file(), text_);
    }
    const GoldenCheck changed = check(other_, UpdateSnapshots::changed);
    EXPECT_FALSE(changed.failure);
    EXPECT_TRUE(changed.update);
    EXPECT_NE(file(), text_);
    EXPECT_FALSE(check(other_, UpdateSnapshots::changed).update);
    EXPECT_TRUE(check(kLog, UpdateSnapshots::all).update);
    EXPECT_EQ(file(), text_);
}

TEST_F(GoldenLog, IgnoresVerdicts) {
    const std::string fail =
        R"({"tick":90,"time":1.5,"event":"expect.fail","object":"never","line":7,"message":"x"})";
    EXPECT_EQ(diagnostic({kHeader, kStart, kEnter, fail, end_line("fail", 2)}), "");
    EXPECT_THAT(diagnostic({kHeader, kStart, kEnter, fail, end_line("fail", 2, "00000000000000ac")}),
                testing::ContainsRegex("hash .*00000000000000ac .*00000000000000ab"));
}

TEST_F(GoldenLog, ReportsTheFirstDifferenceAndItsPlace) {
    std::string farther = kEnter;
    farther.replace(farther.find("3.6"), 3, "3.7");
    EXPECT_THAT(
        diagnostic({kHeader, kStart, farther, end_line("pass", 1)}),
        ContainsRegex("log.jsonl, line 3.*1\\.000000 s trigger.enter door.*pos .*0\\.000,0\\.000,3\\.700 "
                      ".*0\\.000,0\\.000,3\\.600.*--update-snapshots=changed"));
    EXPECT_THAT(diagnostic(other_),
                ContainsRegex("line 3.*1\\.500000 s walk.end visit .*1\\.000000 s trigger.enter door"));
    EXPECT_THAT(diagnostic({kHeader, kStart}),
                ContainsRegex("line 3.*the run ends there.*000060    1\\.000000 trigger.enter    door"));
    Lines more = kLog;
    more.push_back(kEnter);
    EXPECT_THAT(diagnostic(more), ContainsRegex("line 5.*the golden log ends there.*trigger.enter"));
    std::string faster = kHeader;
    faster.replace(faster.find("60"), 2, "120");
    EXPECT_THAT(diagnostic({faster, kStart, kEnter, end_line("pass", 1)}),
                ContainsRegex("line 1.*tps .*120 .*60"));
}

TEST_F(GoldenLog, FailureHasItsTickAndTheEventsBefore) {
    check(kLog, UpdateSnapshots::missing);
    const GoldenCheck checked =
        check({kHeader, kStart, kEnter, end_line("pass", 1, "ff")}, UpdateSnapshots::none);
    ASSERT_TRUE(checked.failure);
    const engine::FailureScene& scene = checked.failure->scene;
    EXPECT_EQ(scene.tick, 90);
    EXPECT_EQ(scene.time, 1.5);
    EXPECT_EQ(scene.position, Eigen::Vector3d(0.0, 0.0, 3.6));
    EXPECT_THAT(
        scene.last_events,
        testing::ElementsAre("000000    0.000000 walk.start       visit             pos=0.000,0.000,5.000",
                             "000060    1.000000 trigger.enter    door              "
                             "pos=0.000,0.000,3.600 at=0.250"));
}

TEST_F(GoldenLog, MayBeFormattedDifferently) {
    folder_.write(
        "visit.walk.yaml-snapshots/log.jsonl",
        kHeader + "\n" +
            R"({ "tick": 0, "time": 0, "event": "walk.start", "object": "visit", "pos": [0, 0, 5] })" + "\n" +
            kEnter + "\n" + end_line("pass", 1));
    EXPECT_FALSE(check(kLog, UpdateSnapshots::none).failure);
}

TEST_F(GoldenLog, IsRefusedWithoutAnEchoIfItIsGarbage) {
    for (const std::string& text :
         {std::string("\n"), std::string("{\"walk_log\":1"), std::string(5000, '['), std::string(300, '\0'),
          std::string("root:secret\n"), kHeader + "\n[]\n", kHeader + "\nroot:secret\n",
          kHeader + "\n{\"tick\":\"x\",\"time\":[],\"event\":3,\"object\":null}\n"}) {
        folder_.write("visit.walk.yaml-snapshots/log.jsonl", text);
        try {
            check(kLog, UpdateSnapshots::none);
            ADD_FAILURE() << text;
        } catch (const scene::InputError& error) {
            EXPECT_EQ(error.diagnostics().front().code.text(), "unreadable");
            EXPECT_EQ(std::string(error.what()).find("secret"), std::string::npos) << error.what();
        }
    }
    folder_.write("visit.walk.yaml-snapshots/log.jsonl", "");
    EXPECT_TRUE(check(kLog, UpdateSnapshots::none).failure);
}

/// However long it is: nothing after that line is kept.
TEST_F(GoldenLog, IsReadUpToTheFirstLineThatIsNone) {
    folder_.write("visit.walk.yaml-snapshots/log.jsonl", kHeader + std::string(1'000'000, '\n'));
    try {
        check(kLog, UpdateSnapshots::none);
        ADD_FAILURE();
    } catch (const scene::InputError& error) {
        EXPECT_EQ(error.diagnostics().front().mark.line, 2);
    }
}

TEST_F(GoldenLog, LeavesNothingBehindIfItCannotBeWritten) {
    folder_.write("visit.walk.yaml-snapshots/log.jsonl/in-the-way", "");
    EXPECT_THROW(check(kLog, UpdateSnapshots::all), std::runtime_error);
    EXPECT_THROW(check(kLog, UpdateSnapshots::none), std::runtime_error);
    std::size_t entries = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path() / "visit.walk.yaml-snapshots")) {
        entries += entry.exists() ? 1U : 0U;
    }
    EXPECT_EQ(entries, 1U);
}

}  // namespace
}  // namespace campuswalk::tools
