#pragma once

#include <optional>
#include <string>

#include "tools/campuswalk/cluster/job_scripts.h"
#include "tools/campuswalk/run/output/job_folder.h"

namespace campuswalk::tools {

// What every use of Slurm does on the machine where it is started.

/// The path of this program, as a shell's word.
std::string this_program();

/// Throws scene::InputError (job-unfinished) while a job that was submitted from the folder waits or runs.
void refuse_if_busy(const JobFolder& folder);

/// What the tasks sign their results with, and the merge demands: CAMPUSWALK_RUN_KEY, or else a key made from
/// this user's own. nullopt if there is neither.
std::optional<std::string> key_of_tasks();

/// Removes what an earlier job has left, but for its results, and makes the folders that tasks write to.
void clear_job(const JobFolder& folder);

/// How to submit the folder's scripts.
void print_submission(const JobFolder& folder);

struct SubmissionStyle {
    std::string what;    ///< "300 walks in 64 shards"
    std::string go_on;   ///< how to go on after Ctrl-C
    bool quiet = false;  ///< print no progress
};

/// Submits the job's scripts, which have been written, waits for its merge, and prints what that has printed.
/// Returns the merge's exit code; kRunFailed if it was lost. On Ctrl-C it cancels both jobs and returns
/// kInterrupted.
int submit_and_wait(const ArrayJob& job, const SubmissionStyle& style);

}  // namespace campuswalk::tools
