#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk/cluster/slurm_options.h"

namespace campuswalk::tools {

/// One campus and the avatar that walks everywhere on it.
struct Exploration {
    std::filesystem::path campus;
    std::string avatar;  ///< as a walk says it
};

/// Several of them.
struct ExplorationRequest {
    std::vector<Exploration> all;
    std::optional<std::filesystem::path> json;  ///< one file of all their reports
    std::filesystem::path output = "out";       ///< for the files of a job, in `slurm-explore`
    int cpus = 1;                               ///< of each task of a job
};

/// Each campus with each avatar, the avatars of a campus one after the other.
std::vector<Exploration> explorations_of(const std::vector<std::filesystem::path>& campuses,
                                         const std::vector<std::string>& avatars);

/// Explores and prints a report; returns the exit code, and sets `json` to the report as JSON.
using Explore = std::function<int(const Exploration& each, std::string& json)>;

/// One after the other. Returns the worst exit code.
int explore_all(const ExplorationRequest& request, const Explore& explore);

/// An array task for each. Waits, prints all reports, writes `json` and returns the worst exit code; 3 if a
/// task didn't come to its end. `arguments` are those of the command line without options_of_exploration().
int explore_on_slurm(const ExplorationRequest& request, const SlurmOptions& slurm,
                     const std::vector<std::string>& arguments);

/// What the job after that array does with what its tasks have left. `job` is the array's number.
int merge_explorations(const ExplorationRequest& request, const std::string& job);

/// The names of options of `explore` that tasks get otherwise, or not at all.
const std::vector<std::string>& options_of_exploration();

}  // namespace campuswalk::tools
