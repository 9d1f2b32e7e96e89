#include <unistd.h>

#include <csignal>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/base/diagnostic.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk/run/cases/frame_helpers.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/selector.h"
#include "tools/campuswalk/run/plan/shard.h"
#include "tools/campuswalk/run/results/verdict.h"
#include "tools/campuswalk/run/workers/worker_pool.h"

namespace campuswalk::tools {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::IsEmpty;
using testing::MatchesRegex;

// ---- finding walks
// ----------------------------------------------------------------------------------------------

class FindWalks : public testing::Test {
protected:
    std::vector<std::string> found(const std::vector<fs::path>& paths) {
        std::vector<std::string> names;
        for (const fs::path& file : find_walks(paths)) {
            names.push_back(
                fs::absolute(file).lexically_normal().lexically_relative(folder_.path()).generic_string());
        }
        return names;
    }

    support::TemporaryFolder folder_;
};

TEST_F(FindWalks, SearchesFoldersRecursivelyAndSorts) {
    for (const char* name : {"b.walk.yaml", "a/z.walk.yaml", "a/b/c.walk.yaml", "a/not.campus.yaml",
                             ".hidden/h.walk.yaml", ".h.walk.yaml", ".walk.yaml"}) {
        folder_.write(name, "");
    }
    EXPECT_THAT(found({folder_.path()}), ElementsAre("a/b/c.walk.yaml", "a/z.walk.yaml", "b.walk.yaml"));
}

TEST_F(FindWalks, ReturnsAFileOnceThatIsNamedTwice) {
    folder_.write("a/z.walk.yaml", "");
    EXPECT_THAT(found({folder_.path() / "a/z.walk.yaml", folder_.path() / "a", folder_.path() / "a/../a"}),
                ElementsAre("a/z.walk.yaml"));
}

TEST_F(FindWalks, IgnoresCyclesOfLinks) {
    folder_.write("a/z.walk.yaml", "");
    fs::create_directory_symlink(folder_.path(), folder_.path() / "a/up");
    fs::create_directory_symlink(folder_.path() / "a", folder_.path() / "again");
    EXPECT_THAT(found({folder_.path()}), ElementsAre("a/z.walk.yaml"));
}

TEST_F(FindWalks, ReturnsMissingFilesForTheLoaderToReport) {
    EXPECT_THAT(found({folder_.path() / "none.walk.yaml"}), ElementsAre("none.walk.yaml"));
}

TEST(OutputNames, AreRelativeToTheCommonFolder) {
    EXPECT_THAT(output_names({"w/a/x.walk.yaml", "w/a/b/x.walk.yaml", "w/y.walk.yaml"}),
                ElementsAre("a/x", "a/b/x", "y"));
    EXPECT_THAT(output_names({"w/a/x.walk.yaml"}), ElementsAre("x"));
    EXPECT_THAT(output_names({"../a/x.walk.yaml", "../ab/x.walk.yaml"}), ElementsAre("a/x", "ab/x"));
    EXPECT_THAT(output_names({}), IsEmpty());
}

// ---- shards -----------------------------------------------------------------------------------------------

TEST(Shard, SlicesAreConsecutiveAndDifferByAtMostOne) {
    for (std::size_t total = 0; total < 40; ++total) {
        for (int count = 1; count < 10; ++count) {
            std::size_t at = 0;
            std::set<std::size_t> sizes;
            for (int index = 0; index < count; ++index) {
                const Slice slice = slice_of(total, {index, count, "", ""});
                EXPECT_EQ(slice.first, at);
                at = slice.last;
                sizes.insert(slice.last - slice.first);
            }
            EXPECT_EQ(at, total);
            EXPECT_LE(*sizes.rbegin() - *sizes.begin(), 1U);
        }
    }
}

TEST(Shard, IsWrittenWithOneBasedIndex) {
    EXPECT_EQ(parse_shard("1/4").value().index, 0);
    EXPECT_EQ(parse_shard("4/4").value().index, 3);
    for (const char* wrong : {"0/4", "5/4", "1", "/", "1/", "/1", "-1/2", "1/2/3", "a/b", " 1/2", "1/0",
                              "99999999999/99999999999"}) {
        EXPECT_FALSE(parse_shard(wrong)) << wrong;
    }
}

Environment variables(std::map<std::string, std::string> set) {
    return [set = std::move(set)](const std::string& name) {
        const auto found = set.find(name);
        return found == set.end() ? std::nullopt : std::optional(found->second);
    };
}

void expect_shard(const std::map<std::string, std::string>& set, int index, int count) {
    const std::optional<Shard> shard = shard_from(variables(set));
    ASSERT_TRUE(shard);
    EXPECT_EQ(shard->index, index);
    EXPECT_EQ(shard->count, count);
}

TEST(Shard, IsReadFromTheVariablesOfKnownSchedulers) {
    expect_shard({{"CAMPUSWALK_SHARD_INDEX", "0"}, {"CAMPUSWALK_SHARD_COUNT", "3"}}, 0, 3);
    expect_shard({{"TEST_SHARD_INDEX", "2"}, {"TEST_TOTAL_SHARDS", "3"}}, 2, 3);
    expect_shard(
        {{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_TASK_MIN", "1"}, {"SLURM_ARRAY_TASK_COUNT", "8"}}, 0, 8);
    expect_shard({{"SLURM_ARRAY_TASK_ID", "14"},
                  {"SLURM_ARRAY_TASK_MIN", "10"},
                  {"SLURM_ARRAY_TASK_STEP", "2"},
                  {"SLURM_ARRAY_TASK_COUNT", "5"}},
                 2, 5);
    expect_shard({{"JOB_COMPLETION_INDEX", "4"}, {"CAMPUSWALK_SHARD_COUNT", "5"}}, 4, 5);
    EXPECT_FALSE(shard_from(variables({})));
    EXPECT_FALSE(shard_from(variables({{"JOB_COMPLETION_INDEX", "4"}})));  // a job that isn't about shards
}

TEST(Shard, RefusesInvalidVariables) {
    using Set = std::map<std::string, std::string>;
    for (const Set& set :
         {Set{{"CAMPUSWALK_SHARD_INDEX", "3"}, {"CAMPUSWALK_SHARD_COUNT", "3"}},
          Set{{"CAMPUSWALK_SHARD_INDEX", "1"}}, Set{{"CAMPUSWALK_SHARD_COUNT", "2"}},
          Set{{"CAMPUSWALK_SHARD_INDEX", "one"}, {"CAMPUSWALK_SHARD_COUNT", "3"}},
          Set{{"TEST_SHARD_INDEX", "-1"}, {"TEST_TOTAL_SHARDS", "3"}},
          Set{{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_TASK_MIN", "2"}, {"SLURM_ARRAY_TASK_COUNT", "3"}},
          Set{{"SLURM_ARRAY_TASK_ID", "3"},
              {"SLURM_ARRAY_TASK_MIN", "0"},
              {"SLURM_ARRAY_TASK_STEP", "2"},
              {"SLURM_ARRAY_TASK_COUNT", "3"}}}) {
        EXPECT_THROW(shard_from(variables(set)), scene::InputError) << set.begin()->first;
    }
}

// ---- selecting walks --------------------------------------------------------------------------------------

TEST(Selector, MatchesFileNameAndTags) {
    Selector selector;
    selector.require("stairs|smoke", {});
    EXPECT_TRUE(selector.takes("walks/stairs/a.walk.yaml", "a", {}));
    EXPECT_TRUE(selector.takes("walks/a.walk.yaml", "a", {"slow", "smoke"}));
    EXPECT_FALSE(selector.takes("walks/a.walk.yaml", "a", {"slow"}));
}

TEST(Selector, CombinesAllRequirements) {
    Selector selector;
    selector.require("^walks/", {});
    selector.refuse("slow$", {});
    selector.require_tag({"smoke", "stairs"});
    EXPECT_TRUE(selector.takes("walks/a.walk.yaml", "a", {"stairs"}));
    EXPECT_FALSE(selector.takes("a.walk.yaml", "a", {"stairs"}));
    EXPECT_FALSE(selector.takes("walks/a.walk.yaml", "a", {"stairs", "slow"}));
    EXPECT_FALSE(selector.takes("walks/a.walk.yaml", "a", {"other"}));
    EXPECT_TRUE(selector.may_take("walks/a.walk.yaml", "a"));
    EXPECT_FALSE(selector.may_take("a.walk.yaml", "a"));
}

TEST(Selector, RefusesInvalidExpressionsWithTheirPlace) {
    Selector selector;
    try {
        selector.require("a(", {"walks.config.yaml", 3, 9});
        FAIL() << "it was accepted";
    } catch (const scene::InputError& error) {
        EXPECT_EQ(error.diagnostics().at(0).code.text(), "bad-regex");
        EXPECT_EQ(error.diagnostics().at(0).mark.line, 3);
    }
}

TEST(Selector, MatchesPathologicalExpressionsInLinearTime) {
    Selector selector;
    selector.require("(a+)+$", {});
    EXPECT_FALSE(selector.takes(std::string(100'000, 'a') + "b", "", {"b"}));
}

// ---- messages ---------------------------------------------------------------------------------------------

TEST(Messages, AreReassembledFromPiecesOfAnySize) {
    const std::string bytes = framed(Topic::log, "one\n") + framed(Topic::events, "") +
                              framed(Topic::result, std::string("\0\xff{}", 4));
    for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
        MessageReader reader;
        std::vector<std::string> bodies;
        for (std::size_t at = 0; at < bytes.size(); at += piece) {
            reader.add(std::string_view(bytes).substr(at, piece));
            while (const auto message = reader.next()) {
                bodies.push_back(message->body);
            }
        }
        EXPECT_THAT(bodies, ElementsAre("one\n", "", std::string("\0\xff{}", 4))) << piece;
    }
}

TEST(Messages, OfUnknownTopicsAreRefused) {
    MessageReader reader;
    reader.add(std::string("\x7f\0\0\0\0", 5));
    EXPECT_THROW(reader.next(), std::runtime_error);
}

// ---- workers ----------------------------------------------------------------------------------------------

/// Records the events of a pool in their order, one per line.
struct PoolLog {
    std::vector<std::string> lines;
    std::size_t enough = 1'000'000;

    bool run(const Work& work, const std::vector<std::size_t>& tasks, const PoolSettings& settings) {
        PoolListener listener;
        listener.on_result = [](std::size_t, const Ending&) {};
        listener.on_message = [this](std::size_t task, Topic, std::string_view body) {
            lines.push_back(std::to_string(task) + " says " + std::string(body));
        };
        listener.on_end = [this](std::size_t task, const Ending& ending) {
            lines.push_back(std::to_string(task) + (ending.answered ? " answers " : " is lost: ") +
                            ending.text);
            return lines.size() < enough;
        };
        listener.update_progress = [] {};
        return WorkerPool([&work] { return work; }, tasks, listener, settings).run();
    }
};

/// Later tasks are faster, so that they finish in the wrong order.
void talk(std::size_t task, const Send& send) {
    send(Topic::log, "a");
    usleep(static_cast<useconds_t>(2000 * (10 - task % 10)));
    send(Topic::log, "b");
    send(Topic::result, std::to_string(task * task));
}

TEST(WorkerPool, ReportsTheSameWithAnyNumberOfWorkers) {
    const std::vector<std::size_t> tasks = {3, 4, 5, 19, 20, 27, 28, 29};
    std::vector<std::vector<std::string>> logs;
    for (const std::size_t workers : {1U, 2U, 5U}) {
        PoolLog log;
        EXPECT_TRUE(log.run(talk, tasks, {workers, std::nullopt, std::size_t{1} << 20U}));
        logs.push_back(log.lines);
    }
    ASSERT_EQ(logs[0].size(), 3 * tasks.size());
    EXPECT_EQ(logs[0][3], "4 says a");
    EXPECT_EQ(logs[0][5], "4 answers 16");
    EXPECT_EQ(logs[1], logs[0]);
    EXPECT_EQ(logs[2], logs[0]);
}

TEST(WorkerPool, LimitsTheBufferOfEarlyResults) {
    const std::string much(200'000, 'x');
    const Work work = [&](std::size_t task, const Send& send) {
        usleep(task == 0 ? 100'000 : 0);
        for (int i = 0; i < 5; ++i) {
            send(Topic::log, much);
        }
        send(Topic::result, "done");
    };
    PoolLog log;
    EXPECT_TRUE(log.run(work, {0, 1, 2, 3, 4, 5}, {3, std::nullopt, 1000}));
    EXPECT_EQ(log.lines.size(), 6U * 6U);
    EXPECT_EQ(log.lines.back(), "5 answers done");
}

TEST(WorkerPool, ReplacesAWorkerThatDies) {
    const Work work = [](std::size_t task, const Send& send) {
        send(Topic::log, "a");
        if (task == 1) {
            raise(SIGKILL);
        }
        send(Topic::result, "done");
    };
    PoolLog log;
    EXPECT_TRUE(log.run(work, {0, 1, 2}, {1, std::nullopt, std::size_t{1} << 20U}));
    ASSERT_EQ(log.lines.size(), 6U);
    EXPECT_EQ(log.lines[1], "0 answers done");
    EXPECT_EQ(log.lines[2], "1 says a");
    EXPECT_THAT(log.lines[3], MatchesRegex("1 is lost: .*signal 9 \\(Killed\\)"));
    EXPECT_EQ(log.lines[5], "2 answers done");
}

TEST(WorkerPool, StopsTasksThatTakeTooLong) {
    const Work work = [](std::size_t task, const Send& send) {
        usleep(task == 0 ? 60'000'000 : 0);
        send(Topic::result, "done");
    };
    PoolLog log;
    EXPECT_TRUE(log.run(work, {0, 1}, {1, 0.3, std::size_t{1} << 20U}));
    EXPECT_THAT(log.lines,
                ElementsAre(MatchesRegex("0 is lost: .*0\\.3 s.*--kill-after.*"), "1 answers done"));
}

TEST(WorkerPool, SkipsTheRestWhenTheListenerStops) {
    PoolLog log;
    log.enough = 3;
    EXPECT_TRUE(log.run(talk, {7, 8, 9, 9, 9, 9}, {2, std::nullopt, std::size_t{1} << 20U}));
    EXPECT_THAT(log.lines, ElementsAre("7 says a", "7 says b", "7 answers 49"));
}

// ---- processes that draw frames
// ------------------------------------------------------------------------------------

TEST(FrameHelpers, ReturnTheFramesOfEachPartInOrder) {
    FrameHelpers helpers(3, [](std::size_t part, const Send& send) {
        for (int i = 0; i < 3; ++i) {
            send(Topic::frame, std::to_string(part) + ' ' + std::to_string(i));
        }
        send(Topic::result, "");
    });
    EXPECT_EQ(helpers.parts(), 3U);
    for (const int i : {0, 1, 2}) {
        for (const std::size_t part : {1U, 2U}) {
            EXPECT_EQ(helpers.next_frame(part), std::to_string(part) + ' ' + std::to_string(i));
        }
    }
}

std::string diagnostic_of(const FrameHelpers::Draw& draw) {
    FrameHelpers helpers(2, draw);
    EXPECT_EQ(helpers.next_frame(1), "one");
    try {
        return helpers.next_frame(1);
    } catch (const std::runtime_error& error) {
        EXPECT_THROW(helpers.next_frame(1), std::runtime_error);
        return error.what();
    }
}

TEST(FrameHelpers, ReportWhyThereAreNoMoreFrames) {
    EXPECT_EQ(diagnostic_of([](std::size_t, const Send& send) {
                  send(Topic::frame, "one");
                  send(Topic::result, "no driver here");
              }),
              "no driver here");
    EXPECT_NE(diagnostic_of([](std::size_t, const Send& send) {
                  send(Topic::frame, "one");
                  send(Topic::result, "");
              }),
              "");
    EXPECT_THAT(diagnostic_of([](std::size_t, const Send& send) {
                    send(Topic::frame, "one");
                    raise(SIGKILL);
                }),
                testing::HasSubstr("signal 9 (Killed)"));
}

TEST(FrameHelpers, CanBeDestroyedBeforeTheyFinish) {
    FrameHelpers helpers(2, [](std::size_t, const Send& send) {
        while (true) {
            send(Topic::frame, std::string(100'000, 'x'));
        }
    });
    EXPECT_EQ(helpers.next_frame(1).size(), 100'000U);
}

// ---- verdicts ---------------------------------------------------------------------------------------------

engine::WalkResult ended(engine::Outcome outcome) {
    engine::WalkResult result;
    result.name = "a";
    result.outcome = outcome;
    return result;
}

TEST(Verdict, ExitCodeIsThatOfTheWorstOutcome) {
    using engine::Outcome;
    EXPECT_EQ(exit_code_for({}), 0);
    EXPECT_EQ(exit_code_for({ended(Outcome::passed), ended(Outcome::skipped)}), 0);
    EXPECT_EQ(exit_code_for({ended(Outcome::failed), ended(Outcome::passed)}), 1);
    EXPECT_EQ(exit_code_for({ended(Outcome::failed), ended(Outcome::bad_input)}), 2);
    EXPECT_EQ(exit_code_for({ended(Outcome::broken), ended(Outcome::bad_input)}), 3);
    EXPECT_EQ(exit_code_for({ended(Outcome::interrupted), ended(Outcome::broken)}), 130);
}

TEST(Verdict, FailsRepetitionsThatDiffer) {
    engine::WalkResult first = ended(engine::Outcome::passed);
    first.hash = 7;
    engine::WalkResult same = first;
    compare_repetitions(first, same);
    EXPECT_EQ(same.outcome, engine::Outcome::passed);
    engine::WalkResult other = first;
    other.hash = 8;
    other.repetition = 1;
    compare_repetitions(first, other);
    EXPECT_EQ(other.outcome, engine::Outcome::failed);
    ASSERT_EQ(other.failures.size(), 1U);
    EXPECT_EQ(other.failures[0].code, "not-identical");
    EXPECT_THAT(other.failures[0].message,
                MatchesRegex("repetition 2 .*0000000000000008 .*0000000000000007 .*"));
}

}  // namespace
}  // namespace campuswalk::tools
