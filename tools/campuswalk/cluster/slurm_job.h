#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tools/campuswalk/cluster/job_scripts.h"
#include "tools/campuswalk/run/output/job_folder.h"

namespace campuswalk::tools {

/// The numbers of an array job and of the job that merges its results.
struct SlurmJob {
    std::string array;
    std::string merge;
};

/// Writes the scripts. Their folder's own files of an earlier job are to be gone.
void write_scripts(const ArrayJob& job);

/// Submits the scripts of a folder; `variables` are NAME=VALUE, for the jobs' environment. Notes their
/// numbers in the folder. Throws std::runtime_error with what sbatch says, and then nothing is submitted.
SlurmJob submit(const JobFolder& folder, const std::vector<std::string>& variables);

/// What was submitted from a folder.
std::optional<SlurmJob> noted_job(const JobFolder& folder);

/// How many tasks of a job are where, as far as Slurm's queue shows.
struct QueueState {
    int waiting = 0;
    int running = 0;       ///< or just starting or ending
    bool merging = false;  ///< the job that merges waits or runs
    bool answered = true;  ///< false: Slurm can't be asked just now
};
/// From the lines of `squeue --array --noheader --format=%i|%T`.
QueueState queue_state(const SlurmJob& job, std::string_view text);
QueueState ask_queue(const SlurmJob& job);

void cancel(const SlurmJob& job);

/// Waits until the merge has ended and returns its exit code. Shows how far it is, in a status line or else
/// in lines, on standard error. nullopt when the merge was lost: cancelled, or its node died for good.
/// Throws Interrupted on Ctrl-C.
std::optional<int> wait_for_merge(const JobFolder& folder, const SlurmJob& job, int tasks, bool quiet);

}  // namespace campuswalk::tools
