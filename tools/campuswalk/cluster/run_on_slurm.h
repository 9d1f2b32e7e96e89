#pragma once

#include <string>
#include <vector>

#include "tools/campuswalk/cluster/slurm_options.h"
#include "tools/campuswalk/run/plan/run_options.h"

namespace campuswalk::tools {

/// The names of options of `run` that concern only the machine where it is started: those that shards get
/// otherwise, or not at all.
const std::vector<std::string>& options_of_submission();

/// Hands a run to Slurm as an array of shards and a job that merges their reports. Waits for it, prints its
/// report and returns its exit code; with SlurmMode::script it only writes the scripts. `arguments` are those
/// of the command line without options_of_submission().
int run_on_slurm(const RunOptions& options, const SlurmOptions& slurm,
                 const std::vector<std::string>& arguments);

}  // namespace campuswalk::tools
