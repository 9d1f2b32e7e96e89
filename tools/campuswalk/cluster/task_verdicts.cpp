#include "tools/campuswalk/cluster/task_verdicts.h"

#include <fstream>
#include <optional>
#include <system_error>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct Problem {
    scene::DiagnosticCode code;
    std::string what;
};

/// Of a task whose script hasn't come to its end.
Problem without_end(const std::optional<std::string>& state) {
    if (!state) {
        return {"task-lost",
                "it didn't come to its end, and Slurm knows nothing of it: it was cancelled before it "
                "started, or that is too long ago"};
    }
    const std::string words = " (Slurm: " + *state + ")";
    if (*state == "CANCELLED" || *state == "REVOKED" || *state == "PREEMPTED") {
        return {"task-cancelled", "it was cancelled" + words};
    }
    if (*state == "TIMEOUT" || *state == "DEADLINE") {
        return {"task-timed-out", "it reached its time limit; raise --time, or take more shards" + words};
    }
    if (*state == "OUT_OF_MEMORY") {
        return {"task-failed", "it ran out of memory; raise --mem" + words};
    }
    if (*state == "NODE_FAIL" || *state == "BOOT_FAIL") {
        return {"task-lost", "its node failed" + words};
    }
    if (*state == "FAILED") {
        return {"task-failed", "it was killed" + words};
    }
    return {"task-lost", "it didn't come to its end" + words};
}

}  // namespace

std::map<int, int> ended_tasks(const JobFolder& folder) {
    std::map<int, int> codes;
    std::error_code error;
    for (fs::directory_iterator entry(folder.ended(), error), end; !error && entry != end;
         entry.increment(error)) {
        const std::vector<int> task = tasks_in(entry->path().filename().string());
        std::error_code ignored;
        if (task.size() != 1 || !entry->is_regular_file(ignored)) {
            continue;
        }
        std::ifstream file(entry->path());
        if (int code = 0; file >> code) {
            codes[task.front()] = code;
        }
    }
    return codes;
}

std::vector<std::string> task_problems(const std::string& job, int tasks, const std::map<int, int>& ended,
                                       const std::map<int, TaskResults>& results, const TaskStates& states) {
    std::vector<std::string> lines;
    for (int task = 1; task <= tasks; ++task) {
        const auto code = ended.find(task);
        const auto left = results.find(task);
        const auto state = states.find(task);
        const bool whole = left != results.end() && left->second.whole;
        std::optional<Problem> problem;
        const bool stopped =
            state != states.end() && state->second != "COMPLETED" && state->second != "FAILED";
        if (code == ended.end() || stopped) {
            problem = without_end(state == states.end() ? std::nullopt : std::optional(state->second));
        } else if (!whole || code->second != left->second.exit_code) {
            problem = {"task-failed", "it ended with exit code " + std::to_string(code->second) +
                                          (whole ? ", which its results don't explain"
                                                 : ", and its results aren't complete")};
        }
        if (problem) {
            lines.push_back(scene::to_string({scene::Severity::error,
                                              {"task " + job + "_" + std::to_string(task), 0, 0},
                                              problem->code,
                                              problem->what}));
        }
    }
    return lines;
}

}  // namespace campuswalk::tools
