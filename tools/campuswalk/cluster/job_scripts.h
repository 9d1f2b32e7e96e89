#pragma once

#include <string>
#include <vector>

#include "tools/campuswalk/cluster/slurm_options.h"
#include "tools/campuswalk/run/output/job_folder.h"

namespace campuswalk::tools {

/// An array of tasks, and what is to be done when all of them have ended.
struct ArrayJob {
    JobFolder folder;
    int tasks = 1;
    int cpus = 1;  ///< of each task
    // Command lines of words as a shell reads them (see shell_word): variables are the script's.
    std::vector<std::string> task;    ///< with $folder, $task and $cpus
    std::vector<std::string> merge;   ///< with $folder and $job, the array's number
    std::vector<std::string> sbatch;  ///< options for both, as in "--partition=long"
    std::string after_restart;        ///< what a task does that Slurm starts again, for the script's reader
};

/// sbatch's options for both jobs. Throws scene::InputError (bad-value) for one that couldn't be a line of a
/// script.
std::vector<std::string> sbatch_options(const SlurmOptions& options);

/// Throws scene::InputError (bad-value) for a folder whose name sbatch wouldn't take as it is.
void check_name_for_scripts(const std::filesystem::path& folder);

/// The script of the array's tasks: a task that was killed is handed to Slurm again, and one that ended says
/// so in its file of JobFolder::ended.
std::string shard_script(const ArrayJob& job);

/// The script of the job after them, whose argument is the array's number.
std::string merge_script(const ArrayJob& job);

}  // namespace campuswalk::tools
