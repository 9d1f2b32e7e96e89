#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/campuswalk/cluster/slurm_tasks.h"
#include "tools/campuswalk/run/output/job_folder.h"

namespace campuswalk::tools {

/// What a task left behind.
struct TaskResults {
    bool whole = false;  ///< all results of its shard are there
    int exit_code = 0;   ///< that these results call for
};

/// The exit codes that the scripts of tasks have written.
std::map<int, int> ended_tasks(const JobFolder& folder);

/// An error for each of the tasks 1 to `tasks` that hasn't shown that its part of the work was done: one that
/// was cancelled, timed out, lost, or that ended with another exit code than its results call for. `job` is
/// the array's number.
std::vector<std::string> task_problems(const std::string& job, int tasks, const std::map<int, int>& ended,
                                       const std::map<int, TaskResults>& results, const TaskStates& states);

}  // namespace campuswalk::tools
