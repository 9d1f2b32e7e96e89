#pragma once

#include <filesystem>
#include <optional>
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
/// missing-file, foreign-results: without the signature of `key`, if there is one).
MergeOfTasks merge_of_tasks(const std::string& job, const std::vector<std::filesystem::path>& inputs,
                            const std::optional<std::string>& key);

}  // namespace campuswalk::tools
