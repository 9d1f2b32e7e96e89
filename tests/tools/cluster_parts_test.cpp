#include <algorithm>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/base/diagnostic.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk/cluster/job_scripts.h"
#include "tools/campuswalk/cluster/slurm_job.h"
#include "tools/campuswalk/cluster/slurm_program.h"
#include "tools/campuswalk/cluster/slurm_tasks.h"
#include "tools/campuswalk/cluster/task_verdicts.h"
#include "tools/campuswalk/run/plan/balance.h"
#include "tools/campuswalk/run/plan/case_times.h"

namespace campuswalk::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::StartsWith;

using Times = std::vector<std::optional<std::uint64_t>>;

// ---- balance ----------------------------------------------------------------------------------------------

TEST(Balance, WithoutTimesTakesConsecutiveParts) {
    EXPECT_THAT(balanced(Times(5), 2), ElementsAre(0, 0, 1, 1, 1));
    EXPECT_THAT(balanced({}, 3), IsEmpty());
}

TEST(Balance, GivesTheLongestFirstToWhoeverHasLeastToDo) {
    EXPECT_THAT(balanced(Times{5, 4, 3, 3, 3}, 2), ElementsAre(0, 1, 1, 0, 1));  // 8 and 10: Graham's example
    EXPECT_THAT(balanced(Times{1, 1, 1, 9}, 2), ElementsAre(1, 1, 1, 0));
}

TEST(Balance, TakesTheMeanForUnknownTimes) {
    EXPECT_THAT(balanced(Times{10, std::nullopt, 30}, 2), ElementsAre(1, 1, 0));  // 20 + 10 against 30
}

TEST(Balance, LeavesNoShardEmptyIfThereAreEnoughItems) {
    const std::vector<int> shards = balanced(Times{0, 0, 0, 100}, 4);
    EXPECT_THAT(std::set<int>(shards.begin(), shards.end()), ElementsAre(0, 1, 2, 3));
}

/// Against the shortest time that any division takes, by trying all of them.
TEST(Balance, IsWithinGrahamsBound) {
    constexpr int kItems = 8;
    std::uint64_t state = 1;
    const auto dice = [&state] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return (state >> 33U) % 100U + 1;
    };
    const auto longest_of = [](const Times& times, const std::vector<int>& shard_of, int shards) {
        std::vector<std::uint64_t> sums(static_cast<std::size_t>(shards));
        for (std::size_t i = 0; i < times.size(); ++i) {
            sums[static_cast<std::size_t>(shard_of[i])] += *times[i];
        }
        return *std::ranges::max_element(sums);
    };
    for (int round = 0; round < 20; ++round) {
        Times times;
        for (int i = 0; i < kItems; ++i) {
            times.emplace_back(dice());
        }
        const int shards = 3;
        std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
        int divisions = 1;
        for (int i = 0; i < kItems; ++i) {
            divisions *= shards;
        }
        for (int division = 0; division < divisions; ++division) {
            std::vector<int> shard_of;
            for (int rest = division; shard_of.size() < kItems; rest /= shards) {
                shard_of.push_back(rest % shards);
            }
            best = std::min(best, longest_of(times, shard_of, shards));
        }
        EXPECT_LE(9 * longest_of(times, balanced(times, shards), shards), 11 * best);  // 4/3 - 1/9
    }
}

TEST(CaseTimes, AreReadFromResultsAndWrittenAsLines) {
    support::TemporaryFolder folder;
    folder.write(
        "last-run.jsonl",
        "{\"code\":\"x\",\"campuswalk_last_run\":\"y\"}\n{\"microseconds\":12,\"id\":\"a\"}\n{\"id\":\"b\"}\n"
        "{\"microseconds\":15,\"id\":\"a\"}\n{\"microseconds\":-3,\"id\":\"c\"}\n{\"id\":\"cut");
    CaseTimes times;
    add_case_times(folder.path() / "last-run.jsonl", times);
    EXPECT_THAT(times, ElementsAre(Pair("a", 15U)));
    EXPECT_EQ(to_json_lines(times), "{\"id\":\"a\",\"microseconds\":15}\n");
    folder.write("other.txt", "not JSON\n");
    EXPECT_THROW(add_case_times(folder.path() / "other.txt", times), scene::InputError);
    EXPECT_THROW(add_case_times(folder.path() / "none", times), scene::InputError);
}

// ---- what Slurm prints ------------------------------------------------------------------------------------

TEST(SlurmTasks, AreListedAsSlurmListsThem) {
    EXPECT_THAT(tasks_in("3"), ElementsAre(3));
    EXPECT_THAT(tasks_in("[3-5,9]"), ElementsAre(3, 4, 5, 9));
    EXPECT_THAT(tasks_in("1-7:3%2"), ElementsAre(1, 4, 7));
    for (const char* none : {"", "x", "4-", "-4", "9-3", "1-9:0", "4294967297", "(null)"}) {
        EXPECT_THAT(tasks_in(none), IsEmpty()) << none;
    }
}

// As slurm-wlm 22.05 prints them.
TEST(SlurmTasks, HaveStates) {
    EXPECT_THAT(
        states_from_accounting("12_1|COMPLETED\n12_2|CANCELLED by 1000\n12_[3-4]|PENDING\n13|FAILED\n"),
        ElementsAre(Pair(1, "COMPLETED"), Pair(2, "CANCELLED"), Pair(3, "PENDING"), Pair(4, "PENDING")));
    EXPECT_THAT(states_from_controller(
                    "JobId=8 ArrayJobId=1 ArrayTaskId=7 JobName=a.sh JobState=TIMEOUT Reason=None\n"
                    "JobId=1 ArrayJobId=1 ArrayTaskId=8-9 JobName=a.sh JobState=PENDING\n"
                    "JobId=5 JobName=b JobState=FAILED\n"),
                ElementsAre(Pair(7, "TIMEOUT"), Pair(8, "PENDING"), Pair(9, "PENDING")));
    EXPECT_THAT(states_from_accounting("Slurm accounting storage is disabled\n"), IsEmpty());
}

TEST(SlurmJob, IsFoundInTheQueue) {
    const QueueState queue = queue_state(
        {"12", "13"}, "12_1|RUNNING\n12_2|COMPLETING\n12_[3-6]|PENDING\n13|PENDING\n112_1|RUNNING\n");
    EXPECT_EQ(queue.running, 2);
    EXPECT_EQ(queue.waiting, 4);
    EXPECT_TRUE(queue.merging);
    EXPECT_FALSE(queue_state({"12", "13"}, "").merging);
}

TEST(SlurmProgram, ReturnsWhatIsPrintedAndHowItEnded) {
    const SlurmAnswer answer = ask_slurm("sh", {"-c", "echo $WORD; echo err >&2; exit 3"}, {"WORD=word"});
    EXPECT_EQ(answer.exit_code, 3);
    EXPECT_EQ(answer.text, "word\nerr\n");
    EXPECT_EQ(ask_slurm("/no/such/program", {}).exit_code, 127);
}

// ---- verdicts ---------------------------------------------------------------------------------------------

TEST(TaskProblems, AreNoneIfAllTasksDidTheirPart) {
    EXPECT_THAT(task_problems("12", 2, {{1, 0}, {2, 1}}, {{1, {true, 0}}, {2, {true, 1}}},
                              {{1, "COMPLETED"}, {2, "FAILED"}}),
                IsEmpty());
    EXPECT_THAT(task_problems("12", 1, {{1, 0}}, {{1, {true, 0}}}, {}), IsEmpty());  // Slurm has forgotten it
}

std::string only_problem(const std::map<int, int>& ended, const std::map<int, TaskResults>& results,
                         const TaskStates& states) {
    const std::vector<std::string> problems = task_problems("12", 1, ended, results, states);
    return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

TEST(TaskProblems, NameTasksWithoutAnEnd) {
    const std::string task = "task 12_1: error ";
    EXPECT_THAT(only_problem({}, {}, {}), StartsWith(task + "task-lost: "));
    EXPECT_THAT(only_problem({}, {}, {{1, "CANCELLED"}}), StartsWith(task + "task-cancelled: "));
    EXPECT_THAT(only_problem({}, {}, {{1, "TIMEOUT"}}), StartsWith(task + "task-timed-out: "));
    EXPECT_THAT(only_problem({}, {}, {{1, "NODE_FAIL"}}), StartsWith(task + "task-lost: "));
    EXPECT_THAT(only_problem({}, {}, {{1, "OUT_OF_MEMORY"}}), StartsWith(task + "task-failed: "));
    EXPECT_THAT(only_problem({}, {{1, {true, 0}}}, {{1, "FAILED"}}), StartsWith(task + "task-failed: "));
    EXPECT_THAT(only_problem({}, {{1, {true, 0}}}, {{1, "PENDING"}}), StartsWith(task + "task-lost: "));
}

TEST(TaskProblems, NameTasksWhoseResultsDoNotFitTheirEnd) {
    EXPECT_THAT(only_problem({{1, 0}}, {}, {{1, "COMPLETED"}}), HasSubstr("error task-failed: "));
    EXPECT_THAT(only_problem({{1, 0}}, {{1, {false, 0}}}, {}), HasSubstr("error task-failed: "));
    EXPECT_THAT(only_problem({{1, 3}}, {{1, {true, 0}}}, {}), HasSubstr("exit code 3"));
    EXPECT_THAT(only_problem({{1, 0}}, {{1, {true, 0}}}, {{1, "CANCELLED"}}),
                HasSubstr("error task-cancelled: "));
}

// ---- scripts ----------------------------------------------------------------------------------------------

TEST(SbatchOptions, BecomeLinesOfAScript) {
    SlurmOptions options;
    options.partition = "long";
    options.mem = "4G";
    options.sbatch = {"--qos=high"};
    EXPECT_THAT(sbatch_options(options), ElementsAre("--partition=long", "--mem=4G", "--qos=high"));
    options.sbatch = {"qos"};
    EXPECT_THROW(sbatch_options(options), scene::InputError);
    options.sbatch = {"--comment=a\nrm -r"};
    EXPECT_THROW(sbatch_options(options), scene::InputError);
    for (const char* name : {"a\"b", "a%b", "a\nb", "a#b"}) {
        EXPECT_THROW(check_name_for_scripts(name), scene::InputError) << name;
    }
    EXPECT_NO_THROW(check_name_for_scripts("out put/slurm"));
}

}  // namespace
}  // namespace campuswalk::tools
