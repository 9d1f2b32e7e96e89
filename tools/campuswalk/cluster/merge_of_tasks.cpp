#include "tools/campuswalk/cluster/merge_of_tasks.h"

#include <map>
#include <system_error>
#include <utility>

#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/cluster/slurm_tasks.h"
#include "tools/campuswalk/cluster/task_verdicts.h"
#include "tools/campuswalk/run/output/job_folder.h"
#include "tools/campuswalk/run/results/result_file.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// A task that never started has no report, and one that was killed may have an empty one.
std::vector<ResultFile> reports_of_tasks(const JobFolder& folder, int tasks,
                                         const std::optional<std::string>& key) {
    std::vector<ResultFile> files;
    for (int task = 1; task <= tasks; ++task) {
        const fs::path file = folder.results() / (std::to_string(task) + ".jsonl");
        std::error_code ignored;
        if (!fs::exists(file, ignored)) {
            continue;
        }
        if (std::optional<ResultFile> report = ResultFile::open(file, key)) {
            files.push_back(std::move(*report));
        }
    }
    return files;
}

}  // namespace

MergeOfTasks merge_of_tasks(const std::string& job, const std::vector<fs::path>& inputs,
                            const std::optional<std::string>& key) {
    if (inputs.size() != 1) {
        throw error_about("--slurm", "bad-value", "it takes one folder, which run --slurm has made");
    }
    const JobFolder folder{inputs.front()};
    const std::optional<ResultFile> header = ResultFile::open(folder.plan(), key);
    if (!header) {
        throw error_about(folder.plan(), "bad-report", "this isn't the plan of a job; submit it again");
    }
    const int tasks = header->plan().shards;
    MergeOfTasks merge{MergedRun(header->plan(), folder.root, reports_of_tasks(folder, tasks, key)), {}};
    std::map<int, TaskResults> results;
    for (const auto& [shard, state] : merge.run.states()) {
        results[shard] = {state.whole, state.exit_code};
    }
    merge.problems = task_problems(job, tasks, ended_tasks(folder), results, ask_task_states(job));
    return merge;
}

}  // namespace campuswalk::tools
