// The examples of expectations: every walk in the folder ends as its status says, and together they show
// every expectation both passing and failing.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_run.h"
#include "engine/observers/json_lines.h"
#include "engine/report/outcome.h"
#include "engine/simulation/check_walk.h"
#include "engine/simulation/run_walk.h"

namespace campuswalk::support {
namespace {

namespace fs = std::filesystem;

using namespace engine;

const fs::path& folder() {
    static const fs::path path = fs::path(CAMPUSWALK_SOURCE_DIR) / "config" / "walks" / "expectations";
    return path;
}

std::vector<fs::path> files_in_folder() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
        if (entry.path().string().ends_with(".walk.yaml")) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

struct Example {
    fs::path file;
    Walk walk;
    std::shared_ptr<const scene::CampusDescription> campus;
};

/// All of them, read once: the campus that they name takes longest.
const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> read;
        for (const fs::path& file : files_in_folder()) {
            config::Run run = config::load_run(file, {});
            read.push_back({file, std::move(run.walk), std::move(run.campus)});
        }
        return read;
    }();
    return all;
}

struct Played {
    WalkSummary summary;
    std::string log;  ///< JSON lines
};

/// Each campus is built once.
Played play(const Example& example) {
    static std::map<std::string, std::unique_ptr<scene::Campus>> campuses;
    std::unique_ptr<scene::Campus>& campus = campuses[example.campus->name];
    if (!campus) {
        std::vector<scene::Diagnostic> warnings;
        campus = std::make_unique<scene::Campus>(
            scene::load_campus(*example.campus, collision::make_bullet_broad_phase(), warnings));
    }
    Played played;
    for (const scene::Diagnostic& mistake : check_walk(*campus, example.walk)) {
        ADD_FAILURE() << scene::to_string(mistake);
    }
    JsonLines log([&](std::string_view line) { played.log.append(line) += '\n'; });
    const std::array<Observer*, 1> observers = {&log};
    played.summary = run_walk(*campus, example.walk, observers);
    return played;
}

std::string contents(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Up to the walk's end, which holds the verdict.
std::string without_end(const std::string& log) {
    return log.substr(0, log.rfind("\"event\":\"walk.end\""));
}

/// All failures, including that of a golden log, which is compared with its file here.
std::vector<Failure> failures_of(const Played& played, const Example& example) {
    const fs::path recorded = fs::path(example.file.string() + "-snapshots") / "log.jsonl";
    std::vector<Failure> failures = played.summary.failures;
    for (const Expectation& expectation : example.walk.expectations) {
        const auto* log = std::get_if<ExpectLog>(&expectation);
        if (log != nullptr && without_end(contents(recorded)) != without_end(played.log)) {
            failures.push_back({log->mark, "log", "differs from the recorded log", {}});
        }
    }
    return failures;
}

std::string name_of_plain(const PlainExpectation& plain) {
    return std::visit([](const auto& expected) { return std::string(expected.kName); }, plain);
}

/// The names of the expectations below `expect` and in steps, with `not-` before negated ones.
std::set<std::string> names_in(const Walk& walk) {
    std::vector<Expectation> all = walk.expectations;
    for (const Step& step : walk.steps) {
        if (const auto* expect = std::get_if<ExpectStep>(&step)) {
            all.insert(all.end(), expect->expectations.begin(), expect->expectations.end());
        }
    }
    std::set<std::string> names;
    for (const Expectation& expectation : all) {
        if (const auto* plain = std::get_if<PlainExpectation>(&expectation)) {
            names.insert(name_of_plain(*plain));
        } else if (const auto* negation = std::get_if<ExpectNot>(&expectation)) {
            names.insert("not-" + name_of_plain(negation->what));
        } else if (const auto* visible = std::get_if<ExpectVisible>(&expectation)) {
            names.insert(code_of(*visible));
        } else {
            names.emplace(std::holds_alternative<ExpectLog>(expectation) ? ExpectLog::kName
                                                                         : ExpectSnapshot::kName);
        }
    }
    return names;
}

/// Whether something kept the avatar from where it should have got: then the failure says what.
bool is_about_obstacles(const std::string& code) {
    const std::set<std::string> codes = {"blocked",    "enclosed",       "unreachable", "reachable",
                                         "blocked_by", "not-blocked_by", "stuck",       "not-stuck"};
    return codes.contains(code);
}

TEST(ExpectationWalks, HaveTheFactsOfObstacles) {
    std::size_t checked = 0;
    for (const Example& example : examples()) {
        for (const Failure& failure : play(example).summary.failures) {
            SCOPED_TRACE(example.file.filename().string() + ": " + failure.message);
            const bool never_blocked = failure.message.find("the avatar was never") != std::string::npos;
            if (is_about_obstacles(failure.code) && !never_blocked) {
                EXPECT_TRUE(failure.reason || !failure.object.empty());
                ++checked;
            }
            if (failure.reason && is_about_obstacles(failure.code)) {
                EXPECT_NE(failure.message.find(text_of(*failure.reason)), std::string::npos);
            }
            EXPECT_EQ(failure.message.find(", expected ") != std::string::npos, !failure.expected.empty());
        }
    }
    EXPECT_GE(checked, 8U);
}

TEST(ExpectationWalks, EndAsTheirStatusSays) {
    EXPECT_GE(examples().size(), 60U);
    for (const Example& example : examples()) {
        SCOPED_TRACE(example.file.filename().string());
        const Played played = play(example);
        // Expectations about images are evaluated by the program, which draws: image_expectations_test.py.
        if (example.walk.status.kind == WalkStatus::Kind::skip ||
            std::ranges::any_of(example.walk.expectations, is_about_images)) {
            continue;
        }
        const EvaluatedWalk evaluated =
            outcome_of_failures(failures_of(played, example), example.walk.status);
        EXPECT_EQ(evaluated.outcome, Outcome::passed);
        for (const Failure& failure : evaluated.failures) {
            if (evaluated.outcome != Outcome::passed) {
                ADD_FAILURE() << failure.mark.line << ": " << failure.code << ": " << failure.message;
            }
        }
    }
}

TEST(ExpectationWalks, ShowEveryExpectationPassingAndFailing) {
    std::set<std::string> passing;
    std::set<std::string> failing;
    std::set<WalkStatus::Kind> statuses;
    for (const Example& example : examples()) {
        const Walk& walk = example.walk;
        statuses.insert(walk.status.kind);
        if (walk.status.kind == WalkStatus::Kind::xfail) {
            failing.insert(walk.status.codes.begin(), walk.status.codes.end());
        }
        for (const std::string& name : names_in(walk)) {
            const bool fails = std::ranges::find(walk.status.codes, name) != walk.status.codes.end();
            if (walk.status.kind == WalkStatus::Kind::run && !fails) {
                passing.insert(name);
            }
        }
    }
    // A fall ends the walk, so no walk with one can pass.
    passing.insert(std::string(ExpectFell::kName));
    for (const std::string& code : failure_codes()) {
        const bool ends_walks =
            code == "blocked" || code == "enclosed" || code == "timeout" || code == "unreachable";
        if (!code.starts_with("not-")) {
            EXPECT_TRUE(ends_walks || passing.contains(code)) << code << " passes nowhere";
            EXPECT_TRUE(failing.contains(code)) << code << " fails nowhere";
        }
    }
    EXPECT_TRUE(std::ranges::any_of(passing, [](const auto& name) { return name.starts_with("not-"); }));
    EXPECT_TRUE(std::ranges::any_of(failing, [](const auto& name) { return name.starts_with("not-"); }));
    EXPECT_TRUE(statuses.contains(WalkStatus::Kind::skip));
}

/// A name with `-passes` or `-fails` promises that verdict.
TEST(ExpectationWalks, AreNamedAfterTheirVerdicts) {
    for (const Example& example : examples()) {
        const Walk& walk = example.walk;
        if (walk.name.ends_with("-passes") && walk.name != "fell-passes") {
            EXPECT_EQ(walk.status.kind, WalkStatus::Kind::run) << walk.name;
        }
        if (walk.name.find("-fails") != std::string::npos) {
            EXPECT_EQ(walk.status.kind, WalkStatus::Kind::xfail) << walk.name;
            EXPECT_FALSE(walk.status.codes.empty()) << walk.name;
        }
    }
}

}  // namespace
}  // namespace campuswalk::support
