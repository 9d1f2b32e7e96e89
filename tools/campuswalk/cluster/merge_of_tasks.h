#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/campuswalk/run/results/merged_run.h"

namespace campuswalk::tools {

/// What the tasks of an array job have left in their folder.
struct MergeOfTasks {
    MergedRun run;                      ///< of the run that was submitted
    std::vector<std::string> problems;  ///< tasks that haven't done their part
};

/// `inputs` is the one folder that run_on_slurm() has made. Throws scene::InputError (bad-value, bad-report,
/// missing-file).
MergeOfTasks merge_of_tasks(const std::string& job, const std::vector<std::filesystem::path>& inputs);

}  // namespace campuswalk::tools
